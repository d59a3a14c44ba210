#include "adit/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "frames.hpp"

namespace adit {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;

CameraModel lens(DistortionModel distortion_model, std::array<double, 8> distortion) {
  CameraModel model = pinhole(640, 480, 80.0);
  model.principal_point_x_px = 331.7;
  model.focal_length_y_px *= 1.01;
  model.distortion_model = distortion_model;
  model.distortion = distortion;
  return model;
}

std::vector<CameraModel> lenses() {
  return {lens(DistortionModel::kNone, {}),
          lens(DistortionModel::kPlumbBob, {-0.28, 0.07, 0.0008, -0.0005, 0.0}),
          lens(DistortionModel::kPlumbBob, {0.12, -0.2, 0.003, 0.002, 0.05}),
          lens(DistortionModel::kRationalPolynomial, {0.8, 0.2, 0.0003, -0.0002, 0.01, 1.1, 0.35, 0.03}),
          lens(DistortionModel::kRationalPolynomial, {-0.2, 0.05, 0.001, 0.001, 0.0, 0.1, 0.02, 0.001}),
          lens(DistortionModel::kEquidistant, {-0.03, 0.004, -0.002, 0.0003}),
          lens(DistortionModel::kEquidistant, {})};
}

TEST(Camera, PinholeIsWhatItSays) {
  const Camera camera(pinhole(640, 480, 90.0));
  EXPECT_NEAR(camera.model().focal_length_x_px, 320.0, 1e-9);
  EXPECT_EQ(camera.model().focal_length_y_px, camera.model().focal_length_x_px);
  EXPECT_EQ(camera.bearing_of(Pixel{319.5, 239.5}).azimuth_rad, 0.0);
  EXPECT_EQ(camera.bearing_of(Pixel{319.5, 239.5}).elevation_rad, 0.0);
  EXPECT_NEAR(camera.bearing_of(Pixel{639.5, 239.5}).azimuth_rad, 45.0 * kDegree_rad, 1e-12);
  EXPECT_NEAR(camera.bearing_of(Pixel{-0.5, 239.5}).azimuth_rad, -45.0 * kDegree_rad, 1e-12);
}

TEST(Camera, RightIsPositiveAndUpIsPositive) {
  for (const CameraModel& model : lenses()) {
    const Camera camera(model);
    EXPECT_GT(camera.bearing_of(Pixel{500, 240}).azimuth_rad, 0.0);
    EXPECT_GT(camera.bearing_of(Pixel{320, 100}).elevation_rad, 0.0);
    EXPECT_GT(camera.normalised_of(Pixel{320, 400}).sy, 0.0);
  }
}

TEST(Camera, PixelsAndDirectionsLeadBack) {
  for (const CameraModel& model : lenses()) {
    const Camera camera(model);
    for (double v = 20; v < 480; v += 23) {
      for (double u = 20; u < 640; u += 31) {
        const NormalisedPoint point = camera.normalised_of(Pixel{u, v});
        const Pixel back = camera.pixel_of(point);
        EXPECT_NEAR(back.u_px, u, 1e-7);
        EXPECT_NEAR(back.v_px, v, 1e-7);
        const NormalisedPoint again = camera.normalised_of(back);
        EXPECT_NEAR(again.sx, point.sx, 1e-9);
        EXPECT_NEAR(again.sy, point.sy, 1e-9);
        const auto pixel = camera.pixel_of(camera.bearing_of(Pixel{u, v}));
        ASSERT_TRUE(pixel.has_value());
        EXPECT_NEAR(pixel->u_px, u, 1e-7);
        EXPECT_NEAR(pixel->v_px, v, 1e-7);
      }
    }
  }
}

TEST(Camera, PointsComeBackToNineDigits) {
  for (const CameraModel& model : lenses()) {
    const Camera camera(model);
    for (double sy = -0.6; sy <= 0.6; sy += 0.1) {
      for (double sx = -0.8; sx <= 0.8; sx += 0.1) {
        const NormalisedPoint point = camera.normalised_of(camera.pixel_of(NormalisedPoint{sx, sy}));
        EXPECT_NEAR(point.sx, sx, 1e-9);
        EXPECT_NEAR(point.sy, sy, 1e-9);
      }
    }
  }
}

TEST(Camera, AnEquidistantLensSeesBehindItself) {
  CameraModel model = lens(DistortionModel::kEquidistant, {});
  model.focal_length_x_px = model.focal_length_y_px = 150.0;
  model.principal_point_x_px = 320.0;
  model.principal_point_y_px = 240.0;
  const Camera camera(model);
  const Bearing bearing = camera.bearing_of(Pixel{320.0 + 150.0 * 100.0 * kDegree_rad, 240.0});
  EXPECT_NEAR(bearing.azimuth_rad, 100.0 * kDegree_rad, 1e-12);
  EXPECT_NEAR(bearing.elevation_rad, 0.0, 1e-12);
  EXPECT_FALSE(camera.pixel_of(bearing).has_value());
  EXPECT_NEAR(camera.bearing_of(Pixel{320.0, 240.0 - 150.0 * 60.0 * kDegree_rad}).elevation_rad, 60.0 * kDegree_rad,
              1e-12);
}

TEST(Camera, AnyFinitePixelGivesNumbers) {
  std::mt19937 random(51);
  for (int round = 0; round < 400; ++round) {
    const auto distortion_model = static_cast<DistortionModel>(test::between(random, 0, 3));
    std::array<double, 8> distortion{};
    const double size = std::pow(10.0, test::between(random, -3, 6));
    for (double& k : distortion) k = size * 0.001 * test::between(random, -1000, 1000);
    const Camera camera(lens(distortion_model, distortion));
    for (const double far : {1.0, 100.0, 1e4, 1e9, 1e154, 1.7e308}) {
      const Pixel pixel{far * 0.01 * test::between(random, -100, 100), far * 0.01 * test::between(random, -100, 100)};
      const NormalisedPoint point = camera.normalised_of(pixel);
      const Bearing bearing = camera.bearing_of(pixel);
      ASSERT_TRUE(std::isfinite(point.sx) && std::isfinite(point.sy)) << round << " " << far;
      ASSERT_TRUE(std::isfinite(bearing.azimuth_rad) && std::isfinite(bearing.elevation_rad)) << round << " " << far;
    }
  }
}

TEST(Camera, OutsideTheLensCircleTheAnswerStaysOnIt) {
  // r (1 - 0.3 r^2) grows up to r = 1.054 and reaches 0.703: a pixel further out has no direction.
  const Camera camera(lens(DistortionModel::kPlumbBob, {-0.3}));
  const NormalisedPoint edge = camera.normalised_of(Pixel{1e5, 239.5});
  EXPECT_NEAR(edge.sx, 1.054, 0.01);
  EXPECT_NEAR(edge.sy, 0.0, 1e-3);
}

TEST(Camera, BearingsAndPointsLeadBack) {
  for (double azimuth = -1.5; azimuth <= 1.5; azimuth += 0.1) {
    for (double elevation = -1.4; elevation <= 1.4; elevation += 0.1) {
      const auto point = normalised_of(Bearing{azimuth, elevation});
      ASSERT_TRUE(point.has_value());
      const Bearing bearing = bearing_of(*point);
      EXPECT_NEAR(bearing.azimuth_rad, azimuth, 1e-12);
      EXPECT_NEAR(bearing.elevation_rad, elevation, 1e-12);
    }
  }
  EXPECT_FALSE(normalised_of(Bearing{0.5 * std::numbers::pi, 0.0}).has_value());
  EXPECT_FALSE(normalised_of(Bearing{-2.0, 0.0}).has_value());
  EXPECT_FALSE(normalised_of(Bearing{std::nan(""), 0.0}).has_value());
}

TEST(Camera, ResizedSeesTheSameDirections) {
  for (const CameraModel& model : lenses()) {
    const Camera full(model);
    const Camera half(resized(model, 320, 240));
    // Pixel 0 of the half frame covers pixels 0 and 1: its centre lies at 0.5.
    const Bearing a = full.bearing_of(Pixel{2 * 70 + 0.5, 2 * 90 + 0.5});
    const Bearing b = half.bearing_of(Pixel{70, 90});
    EXPECT_NEAR(a.azimuth_rad, b.azimuth_rad, 1e-12);
    EXPECT_NEAR(a.elevation_rad, b.elevation_rad, 1e-12);
  }
}

TEST(Camera, WhatIsNoCameraIsRefusedInWords) {
  const auto fault_with = [](auto change) {
    CameraModel model = pinhole(640, 480, 75.0);
    change(model);
    return fault_of(model).value_or("");
  };
  const double nan = std::nan("");
  EXPECT_EQ(fault_with([](CameraModel&) {}), "");
  EXPECT_EQ(fault_with([](CameraModel& m) { m.width = 0; }).find("width: 0 px is not in [16, 8192] px"), 0u);
  EXPECT_EQ(fault_with([](CameraModel& m) { m.height = 9000; }).find("height: 9000 px"), 0u);
  EXPECT_EQ(fault_with([](CameraModel& m) { m.focal_length_x_px = 0; }).find("focal_length_x_px: 0 px"), 0u);
  EXPECT_EQ(fault_with([&](CameraModel& m) { m.focal_length_y_px = nan; }).find("focal_length_y_px: nan"), 0u);
  EXPECT_EQ(fault_with([](CameraModel& m) { m.principal_point_x_px = -641; }).find("principal_point_x_px"), 0u);
  EXPECT_EQ(fault_with([](CameraModel& m) { m.principal_point_y_px = 1e9; }).find("principal_point_y_px"), 0u);
  EXPECT_EQ(fault_with([&](CameraModel& m) {
              m.distortion_model = DistortionModel::kEquidistant;
              m.distortion[3] = nan;
            }).find("distortion[3]: nan"),
            0u);
  EXPECT_EQ(fault_with([&](CameraModel& m) { m.distortion[3] = nan; }), "") << "not used by this model";
  EXPECT_NE(fault_with([](CameraModel& m) { m.distortion_model = static_cast<DistortionModel>(9); }), "");
  EXPECT_THROW(Camera(CameraModel{}), std::invalid_argument);
  EXPECT_THROW((void)pinhole(640, 480, 5.0), std::invalid_argument);
  EXPECT_THROW((void)pinhole(4, 480, 75.0), std::invalid_argument);
}

}  // namespace
}  // namespace adit
