#include "adit/node/velocity.hpp"

#include <gtest/gtest.h>

namespace adit::node {
namespace {

TEST(VelocityTest, MavrosHearsVelocityAndYawRateOfTheBodyAndNothingElse) {
  const PositionTargetFields f = position_target_of({1, 0.7, -0.3, false});
  EXPECT_EQ(f.coordinate_frame, 8);  // FRAME_BODY_NED: given as forward, left, up
  EXPECT_EQ(f.velocity_x, 0.7);
  EXPECT_EQ(f.velocity_y, 0.0);
  EXPECT_EQ(f.velocity_z, 0.0);
  EXPECT_EQ(f.yaw_rate, -0.3);  // no sign is turned
  EXPECT_EQ(f.type_mask, 1479);
  for (const auto used : {kIgnoreVx, kIgnoreVy, kIgnoreVz, kIgnoreYawRate, kForce}) EXPECT_EQ(f.type_mask & used, 0);
  for (const auto unused : {kIgnorePx, kIgnorePy, kIgnorePz, kIgnoreAfx, kIgnoreAfy, kIgnoreAfz, kIgnoreYaw})
    EXPECT_NE(f.type_mask & unused, 0);
}

TEST(VelocityTest, HoverIsZeroAndIsSaid) {
  const PositionTargetFields f = position_target_of({1, 0.0, 0.0, true});
  EXPECT_EQ(f.velocity_x, 0.0);
  EXPECT_EQ(f.yaw_rate, 0.0);
  EXPECT_EQ(f.type_mask, 1479);  // not ignored: zero is an order
}

}  // namespace
}  // namespace adit::node
