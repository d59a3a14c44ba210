#include "adit/node/direction.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace adit::node {
namespace {

/// The x axis, turned.
Direction turned_x(const Quaternion& q) {
  return {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)};
}

TEST(DirectionTest, RightIsPlusXAndUpIsMinusY) {
  EXPECT_GT(direction_of({0.3, 0.0}).x, 0.0);
  EXPECT_LT(direction_of({0.0, 0.3}).y, 0.0);
  EXPECT_DOUBLE_EQ(direction_of({0.0, 0.0}).z, 1.0);
}

TEST(DirectionTest, TheArrowPointsAlongTheBearing) {
  constexpr double kHalf = std::numbers::pi / 2.0;
  for (double azimuth = -kHalf; azimuth <= kHalf; azimuth += 0.1)
    for (double elevation = -kHalf; elevation <= kHalf; elevation += 0.1) {
      const Direction wanted = direction_of({azimuth, elevation});
      const Quaternion q = arrow_of({azimuth, elevation});
      const Direction drawn = turned_x(q);
      EXPECT_NEAR(drawn.x, wanted.x, 1e-9) << azimuth << " " << elevation;
      EXPECT_NEAR(drawn.y, wanted.y, 1e-9) << azimuth << " " << elevation;
      EXPECT_NEAR(drawn.z, wanted.z, 1e-9) << azimuth << " " << elevation;
      EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace adit::node
