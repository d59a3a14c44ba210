// The distortion models against OpenCV's.
#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "adit/camera.hpp"

namespace adit {
namespace {

struct Lens {
  DistortionModel model;
  std::vector<double> coefficients;
};

CameraModel model_of(const Lens& lens) {
  CameraModel model = pinhole(640, 480, 80.0);
  model.focal_length_y_px = 390.0;
  model.principal_point_x_px = 327.3;
  model.principal_point_y_px = 233.1;
  model.distortion_model = lens.model;
  std::copy(lens.coefficients.begin(), lens.coefficients.end(), model.distortion.begin());
  return model;
}

cv::Matx33d matrix_of(const CameraModel& m) {
  return {m.focal_length_x_px, 0, m.principal_point_x_px, 0, m.focal_length_y_px, m.principal_point_y_px, 0, 0, 1};
}

const Lens kLenses[] = {
    {DistortionModel::kPlumbBob, {-0.28, 0.07, 0.0008, -0.0005, 0.0}},
    {DistortionModel::kPlumbBob, {0.12, -0.2, 0.003, 0.002, 0.05}},
    {DistortionModel::kRationalPolynomial, {0.8, 0.2, 0.0003, -0.0002, 0.01, 1.1, 0.35, 0.03}},
    {DistortionModel::kRationalPolynomial, {-0.2, 0.05, 0.001, 0.001, 0.0, 0.1, 0.02, 0.001}},
    {DistortionModel::kEquidistant, {-0.03, 0.004, -0.002, 0.0003}},
    {DistortionModel::kEquidistant, {0.02, -0.01, 0.003, -0.001}},
};

TEST(CameraOpencv, SamePixels) {
  for (const Lens& lens : kLenses) {
    const Camera camera(model_of(lens));
    std::vector<cv::Point3d> points;
    for (double y = -0.6; y <= 0.6; y += 0.1) {
      for (double x = -0.8; x <= 0.8; x += 0.1) points.emplace_back(x, y, 1.0);
    }
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d none(0, 0, 0);
    if (lens.model == DistortionModel::kEquidistant) {
      cv::fisheye::projectPoints(points, pixels, none, none, matrix_of(camera.model()), lens.coefficients);
    } else {
      cv::projectPoints(points, none, none, matrix_of(camera.model()), lens.coefficients, pixels);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Pixel pixel = camera.pixel_of(NormalisedPoint{points[i].x, points[i].y});
      EXPECT_NEAR(pixel.u_px, pixels[i].x, 1e-9);
      EXPECT_NEAR(pixel.v_px, pixels[i].y, 1e-9);
    }
  }
}

TEST(CameraOpencv, SamePoints) {
  for (const Lens& lens : kLenses) {
    const Camera camera(model_of(lens));
    std::vector<cv::Point2d> pixels;
    for (double v = 40; v < 460; v += 29) {
      for (double u = 40; u < 620; u += 37) pixels.emplace_back(u, v);
    }
    std::vector<cv::Point2d> points;
    const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 500, 1e-13);
    if (lens.model == DistortionModel::kEquidistant) {
      cv::fisheye::undistortPoints(pixels, points, matrix_of(camera.model()), lens.coefficients);
    } else {
      cv::undistortPoints(pixels, points, matrix_of(camera.model()), lens.coefficients, cv::noArray(), cv::noArray(),
                          until);
    }
    // fisheye::undistortPoints stops at 1e-8 of an angle.
    const double tolerance = lens.model == DistortionModel::kEquidistant ? 1e-6 : 1e-9;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const NormalisedPoint point = camera.normalised_of(Pixel{pixels[i].x, pixels[i].y});
      EXPECT_NEAR(point.sx, points[i].x, tolerance);
      EXPECT_NEAR(point.sy, points[i].y, tolerance);
    }
  }
}

}  // namespace
}  // namespace adit
