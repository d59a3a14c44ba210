#include "adit/node/camera_info.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::node {
namespace {

CameraInfoMessage calibrated() {
  CameraInfoMessage m;
  m.width = 640;
  m.height = 480;
  m.distortion_model = "plumb_bob";
  m.distortion = {-0.2, 0.05, 0.001, -0.002, 0.0};
  m.matrix = {500, 0, 320, 0, 510, 240, 0, 0, 1};
  return m;
}

TEST(CameraInfoTest, ACalibrationIsTakenFieldByField) {
  const CameraReading reading = camera_of(calibrated());
  ASSERT_TRUE(reading.model) << reading.fault;
  EXPECT_EQ(reading.model->width, 640);
  EXPECT_EQ(reading.model->height, 480);
  EXPECT_EQ(reading.model->focal_length_x_px, 500);
  EXPECT_EQ(reading.model->focal_length_y_px, 510);
  EXPECT_EQ(reading.model->principal_point_x_px, 320);
  EXPECT_EQ(reading.model->principal_point_y_px, 240);
  EXPECT_EQ(reading.model->distortion_model, DistortionModel::kPlumbBob);
  EXPECT_EQ(reading.model->distortion[1], 0.05);
}

TEST(CameraInfoTest, ADriverThatWasNeverCalibratedIsNoFault) {
  CameraInfoMessage m = calibrated();
  m.matrix = {};
  const CameraReading reading = camera_of(m);
  EXPECT_FALSE(reading.model);
  EXPECT_EQ(reading.fault, "");
}

TEST(CameraInfoTest, SimulatorsSendNoDistortionModel) {
  CameraInfoMessage m = calibrated();
  m.distortion_model = "";
  m.distortion = {0, 0, 0, 0, 0};
  ASSERT_TRUE(camera_of(m).model);
  EXPECT_EQ(camera_of(m).model->distortion_model, DistortionModel::kNone);
  m.distortion[0] = 0.1;
  EXPECT_NE(camera_of(m).fault.find("distortion_model"), std::string::npos);
}

TEST(CameraInfoTest, WhatIsNoCalibrationIsNamed) {
  CameraInfoMessage m = calibrated();
  m.distortion_model = "thin_prism";
  EXPECT_NE(camera_of(m).fault.find("'thin_prism'"), std::string::npos);
  m = calibrated();
  m.distortion = {0, 0, 0, 0, 0, 0.1};
  EXPECT_NE(camera_of(m).fault.find("6 coefficients"), std::string::npos);
  m = calibrated();
  m.matrix[0] = std::nan("");
  EXPECT_NE(camera_of(m).fault, "");
  m = calibrated();
  m.width = 0;
  EXPECT_NE(camera_of(m).fault, "");
  m = calibrated();
  m.height = 0xffffffffu;
  EXPECT_NE(camera_of(m).fault, "");
}

TEST(CameraInfoTest, MissingCoefficientsAreZero) {
  CameraInfoMessage m = calibrated();
  m.distortion = {-0.2, 0.05, 0.001, -0.002};
  ASSERT_TRUE(camera_of(m).model);
  EXPECT_EQ(camera_of(m).model->distortion[4], 0.0);
}

TEST(CameraInfoTest, BinningAndRegionMoveThePrincipalPoint) {
  CameraInfoMessage m = calibrated();
  m.distortion_model = "";
  m.distortion.clear();
  m.roi_x_offset = 160;
  m.roi_y_offset = 120;
  m.roi_width = 320;
  m.roi_height = 240;
  m.binning_x = m.binning_y = 2;
  const CameraReading reading = camera_of(m);
  ASSERT_TRUE(reading.model) << reading.fault;
  EXPECT_EQ(reading.model->width, 160);
  EXPECT_EQ(reading.model->height, 120);
  EXPECT_EQ(reading.model->focal_length_x_px, 250);
  EXPECT_DOUBLE_EQ(reading.model->principal_point_x_px, 79.75);
  // A point of the scene keeps its direction: pixels 200 and 201 of the sensor are pixel 20 of the image.
  const Camera whole(*camera_of([] {
                        CameraInfoMessage plain = calibrated();
                        plain.distortion_model = "";
                        plain.distortion.clear();
                        return plain;
                      }())
                          .model);
  const Camera part(*reading.model);
  EXPECT_NEAR(whole.normalised_of(Pixel{200.5, 160.5}).sx, part.normalised_of(Pixel{20, 20}).sx, 1e-12);
  EXPECT_NEAR(whole.normalised_of(Pixel{200.5, 160.5}).sy, part.normalised_of(Pixel{20, 20}).sy, 1e-12);
}

}  // namespace
}  // namespace adit::node
