#include "adit/scattering_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit {
namespace {

TEST(ScatteringDepth, FollowsTheEquations) {
  const LevelTable t = transmission_table(200.0, 0.95, 0.01);
  const LevelTable d = scattering_depth_table(t, 2.0);
  EXPECT_DOUBLE_EQ(t[100], 1.0 - 0.95 * 100.0 / 200.0);
  EXPECT_DOUBLE_EQ(d[100], -std::log(1.0 - 0.95 * 0.5) / 2.0);
  EXPECT_NEAR(t[200], 0.05, 1e-15);
}

TEST(ScatteringDepth, BlackIsDepthZero) {
  const LevelTable d = scattering_depth_table(transmission_table(180.0, 1.0, 0.01), 1.0);
  EXPECT_EQ(d[0], 0.0);
  EXPECT_FALSE(std::signbit(d[0]));
}

TEST(ScatteringDepth, TheFloorKeepsTheLogarithmFinite) {
  const LevelTable t = transmission_table(50.0, 1.0, 0.01);
  EXPECT_EQ(t[50], 0.01);
  EXPECT_EQ(t[255], 0.01);
  EXPECT_DOUBLE_EQ(scattering_depth_table(t, 1.0)[255], -std::log(0.01));
}

TEST(ScatteringDepth, ABlackFrameHasTransmissionOneEverywhere) {
  for (const double a : {0.0, -1.0, std::nan("")}) {
    for (const double t : transmission_table(a, 0.95, 0.01)) EXPECT_EQ(t, 1.0);
  }
}

TEST(ScatteringDepth, NeverFallsWithTheLevel) {
  for (const double a : {1e-6, 0.3, 6.0, 77.7, 255.0}) {
    for (const double omega : {0.01, 0.5, 0.95, 1.0}) {
      for (const double beta : {1e-6, 1.0, 1e6}) {
        const LevelTable d = scattering_depth_table(transmission_table(a, omega, 0.01), beta);
        for (std::size_t level = 0; level < 256; ++level) {
          EXPECT_TRUE(std::isfinite(d[level]) && d[level] >= 0.0);
          EXPECT_GE(d[level], d[level > 0 ? level - 1 : 0]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace adit
