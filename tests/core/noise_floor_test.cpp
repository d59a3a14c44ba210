#include "noise_floor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

constexpr double kGamma = 2.2;

CellPlane plane_of(double level, double slope_per_cell, double noise_level, unsigned seed = 1) {
  CellPlane plane(160, 120);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, noise_level);
  for (int v = 0; v < plane.height; ++v) {
    for (int u = 0; u < plane.width; ++u) {
      const double here = level + slope_per_cell * (u - 80) + 0.5 * slope_per_cell * (v - 60) + noise(random);
      plane.row(v)[u] = static_cast<std::int16_t>(std::lround(here * kLevelParts));
    }
  }
  return plane;
}

double light_of(int part) { return std::pow(static_cast<double>(part) / kLevelPartsMax, kGamma); }

TEST(NoiseFloor, NoiseIsToldFromSlopes) {
  EXPECT_NEAR(NoiseFloor::noise_share(plane_of(100.0, 0.0, 5.0)), 0.05, 0.002);
  EXPECT_NEAR(NoiseFloor::noise_share(plane_of(100.0, 0.5, 5.0)), 0.05, 0.002);
  EXPECT_LT(NoiseFloor::noise_share(plane_of(100.0, 0.5, 0.0)), 0.002);
  EXPECT_EQ(NoiseFloor::noise_share(CellPlane(160, 120)), 0.0);
  EXPECT_EQ(NoiseFloor::noise_share(CellPlane(2, 120)), 0.0);
}

TEST(NoiseFloor, AQuietFrameHasNone) {
  EXPECT_EQ(NoiseFloor::floor_share(0.0), 0.0);
  EXPECT_EQ(NoiseFloor::floor_share(0.05), 0.0);
  EXPECT_GT(NoiseFloor::floor_share(0.06), 0.0);
  EXPECT_DOUBLE_EQ(NoiseFloor::floor_share(0.5), NoiseFloor::floor_share(0.1));
  EXPECT_LT(NoiseFloor::floor_share(0.5), 1.0);
}

TEST(NoiseFloor, IsTakenOffInLight) {
  NoiseFloor floor(kGamma);
  CellPlane levels = plane_of(60.0, 0.3, 2.0);
  const CellPlane before = levels;
  const auto [least, most] = std::minmax_element(before.values.begin(), before.values.end());
  floor.take_off(0.8, *least, *most, levels);
  const double off = light_of(static_cast<int>(0.8 * *least));
  for (std::size_t i = 0; i < levels.values.size(); ++i) {
    const double left = light_of(before.values[i]) - off;
    EXPECT_LE(light_of(levels.values[i]), left + 1e-6);
    EXPECT_GT(light_of(levels.values[i] + 1), left - 1e-6);
  }
}

TEST(NoiseFloor, NothingIsTakenFromBlackNorFromWhite) {
  NoiseFloor floor(kGamma);
  CellPlane levels(160, 120);
  levels.values[7] = kLevelPartsMax;
  const CellPlane before = levels;
  floor.take_off(0.9, 0, kLevelPartsMax, levels);
  EXPECT_EQ(levels.values, before.values);
}

/// A tube in the light of a lamp that is far too weak, through a sensor at full gain: noise below zero is cut off, and
/// the tone curve lifts what stays.
test::Frame dim_tube(double azimuth_rad, double light, unsigned seed) {
  test::Frame frame(640, 480, PixelFormat::kGrey8);
  const Camera camera(pinhole(640, 480, 75.0));
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.004);
  for (int v = 0; v < frame.height; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const Bearing at = camera.bearing_of({static_cast<double>(u), static_cast<double>(v)});
      const double cosine = std::cos(at.elevation_rad) * std::cos(at.azimuth_rad - azimuth_rad);
      const double seen = light * std::pow(1.0 - cosine * cosine, 1.5) + noise(random);
      *frame.pixel(u, v) = static_cast<std::uint8_t>(
          std::clamp(std::lround(255.0 * std::pow(std::max(0.0, seen), 1.0 / kGamma)), 0L, 255L));
    }
  }
  return frame;
}

// With the floor left on, three of these six are told with a confidence of 0.4 to 0.9 and one not at all.
TEST(NoiseFloor, APassageInHardlyAnyLightIsFoundAndIsNotTakenForDust) {
  FinderConfig config;
  config.method = Method::kAdit;
  OpenSpaceFinder finder(config, Camera(pinhole(640, 480, 75.0)));
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const double azimuth_rad = (seed % 2 == 0 ? 1.0 : -1.0) * 0.15;
    const OpenSpace space = finder.find(dim_tube(azimuth_rad, 0.012, seed).view());
    ASSERT_EQ(space.status, Status::kFound) << "seed " << seed;
    EXPECT_FALSE(space.flags.dust) << "seed " << seed;
    EXPECT_GT(space.confidence, 0.9) << "seed " << seed;
    EXPECT_NEAR(space.bearing.azimuth_rad, azimuth_rad, 0.13) << "seed " << seed;
  }
}

}  // namespace
}  // namespace adit
