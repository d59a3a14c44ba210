#include "adit/io/camera_file.hpp"

#include <gtest/gtest.h>

#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::io;
using adit::DistortionModel;
using adit::testing::message_of;

/// As camera_calibration writes it.
std::string camera_info(const std::string& model = "plumb_bob", const std::string& data = "0.1, -0.2, 0.001, 0.002, 0",
                        int count = 5) {
  return "image_width: 640\nimage_height: 480\ncamera_name: front\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
         "  data: [ 510.5,    0. , 320.25,\n             0. , 511.5, 240.75,\n             0. ,   0. ,   1. ]\n"
         "distortion_model: " +
         model + "\ndistortion_coefficients:\n  rows: 1\n  cols: " + std::to_string(count) + "\n  data: [" + data +
         "]\nrectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
         "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0]\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string fault(const std::string& yaml) {
  return message_of<ConfigError>([&] { (void)camera_of_yaml(yaml, "cam.yaml"); });
}

TEST(CameraFile, FiguresOfACalibration) {
  const adit::CameraModel camera = camera_of_yaml(camera_info(), "cam.yaml");
  EXPECT_EQ(camera.width, 640);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.focal_length_x_px, 510.5);
  EXPECT_EQ(camera.focal_length_y_px, 511.5);
  EXPECT_EQ(camera.principal_point_x_px, 320.25);
  EXPECT_EQ(camera.principal_point_y_px, 240.75);
  EXPECT_EQ(camera.distortion_model, DistortionModel::kPlumbBob);
  EXPECT_EQ(camera.distortion, (std::array<double, 8>{0.1, -0.2, 0.001, 0.002, 0, 0, 0, 0}));
}

TEST(CameraFile, EveryModel) {
  EXPECT_EQ(camera_of_yaml(camera_info("plumb_bob", "0.1, -0.2, 0, 0", 4), "c").distortion[1], -0.2);
  const auto rational = camera_of_yaml(camera_info("rational_polynomial", "0.1,0.2,0,0,0.01,0.1,0.2,0.03", 8), "c");
  EXPECT_EQ(rational.distortion_model, DistortionModel::kRationalPolynomial);
  EXPECT_EQ(rational.distortion[7], 0.03);
  EXPECT_EQ(camera_of_yaml(camera_info("equidistant", "0.1,0.01,0,0", 4), "c").distortion_model,
            DistortionModel::kEquidistant);
  // OpenCV's calibration writes zeros for the terms that it did not estimate.
  EXPECT_EQ(camera_of_yaml(camera_info("rational_polynomial", "0.1,0,0,0,0,0,0,0.03,0,0,0,0", 12), "c").distortion[7],
            0.03);
}

TEST(CameraFile, FaultsNameLineAndField) {
  EXPECT_TRUE(fault(replaced(camera_info(), "image_width: 640", "image_widht: 640"))
                  .starts_with("cam.yaml:1: image_width: missing"))
      << fault(replaced(camera_info(), "image_width: 640", "image_widht: 640"));
  EXPECT_EQ(fault(replaced(camera_info(), "640", "wide")), "cam.yaml:1: image_width: 'wide' is not a whole number");
  EXPECT_EQ(fault(camera_info("plum_bob")),
            "cam.yaml:10: distortion_model: 'plum_bob' is not known; did you mean 'plumb_bob'?");
  EXPECT_TRUE(fault(camera_info("plumb_bob", "0.1, 0.2", 2)).starts_with("cam.yaml:")) << "two coefficients";
  EXPECT_NE(fault(camera_info("plumb_bob", "0.1, 0.2, 0, 0, 0", 4)).find("rows x cols is 4, but data has 5"),
            std::string::npos);
  EXPECT_NE(fault(camera_info("equidistant", "0.1, 0.2, 0, 0, 7", 5)).find("5 numbers, but equidistant has 4"),
            std::string::npos);
  EXPECT_NE(fault(replaced(camera_info(), "510.5,    0. ,", "510.5,    2. ,")).find("skewed"), std::string::npos);
  EXPECT_NE(fault(replaced(camera_info(), "510.5", "-510.5")), "");
  EXPECT_NE(fault(replaced(camera_info(), "510.5", "fx")).find("camera_matrix: 'fx' is not a number"),
            std::string::npos);
  EXPECT_NE(fault("finder:\n  omega: 1\n").find("missing"), std::string::npos);
  EXPECT_NE(fault("# nothing\n").find("missing"), std::string::npos);
  EXPECT_NE(fault("[1, 2"), "");
}

TEST(CameraFile, MissingFile) {
  EXPECT_EQ(message_of<ConfigError>([] { (void)read_camera("no/such.yaml"); }), "no/such.yaml: no such file");
}

}  // namespace
