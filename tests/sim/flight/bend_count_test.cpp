#include "adit/sim/bend_count.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace adit::sim {
namespace {

constexpr double kRight = std::numbers::pi / 2.0;

/// A flight in steps of 5 cm along a passage that goes the same way.
struct Flown {
  BendCount count;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;

  /// @param passage_off_rad of the passage from the flight; in an arc it is where the arc goes 5 m further on.
  void go(double way_m, double turn_rad = 0.0, double passage_off_rad = 0.0) {
    const int steps = static_cast<int>(std::lround(way_m / 0.05));
    passage_off_rad += 2.5 * turn_rad / way_m;
    for (int i = 0; i < steps; ++i) {
      yaw_rad += turn_rad / steps;
      place += 0.05 * Eigen::Vector3d(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
      count.add(place, yaw_rad + passage_off_rad);
    }
  }
};

TEST(BendCount, EachRightAngleBetweenStraightPiecesIsOne) {
  Flown f;
  f.go(20);
  EXPECT_EQ(f.count.bends(), 0);
  f.go(8, kRight);
  EXPECT_EQ(f.count.bends(), 0) << "not before it goes straight again";
  f.go(8);
  EXPECT_EQ(f.count.bends(), 1);
  f.go(8, -kRight);
  f.go(8);
  f.go(5, -kRight);
  f.go(30);
  EXPECT_EQ(f.count.bends(), 3);
  f.go(16, kRight);
  f.go(10);
  EXPECT_EQ(f.count.bends(), 4) << "a wide one, radius 10 m";
  f.go(16, -kRight);
  f.go(10);
  EXPECT_EQ(f.count.bends(), 5) << "and one the other way";
}

TEST(BendCount, AnSWithoutStraightWayIsAsManyBendsAsItHasTurns) {
  Flown f;
  f.go(20);
  f.go(15.7, kRight);
  f.go(15.7, -kRight);
  f.go(15.7, kRight);
  EXPECT_EQ(f.count.bends(), 2) << "the third is not over";
  f.go(10);
  EXPECT_EQ(f.count.bends(), 3);
  for (int i = 0; i < 2; ++i) {  // corners that are cut: 57 degrees are left of 90
    f.go(10, -1.0);
    f.go(10, 1.0);
  }
  f.go(10);
  EXPECT_EQ(f.count.bends(), 7);
}

TEST(BendCount, AnSThatThePassageDoesNotTakeIsNone) {
  Flown f;
  f.go(20);
  // The passage goes straight on: it lies off the nose by as much as the nose has turned.
  double off_rad = 0.0;
  const auto swing = [&](double way_m, double turn_rad) {
    for (int i = 0; i < 10; ++i) {
      f.go(way_m / 10.0, turn_rad / 10.0, off_rad - 2.5 * turn_rad / way_m);
      off_rad -= turn_rad / 10.0;
    }
  };
  for (int i = 0; i < 4; ++i) {
    swing(10, 0.9);
    swing(20, -1.8);
    swing(10, 0.9);
  }
  f.go(10);
  EXPECT_EQ(f.count.bends(), 0);
}

TEST(BendCount, WeavingInAStraightPassageIsNone) {
  Flown f;
  f.go(10);
  for (int i = 0; i < 10; ++i) {
    f.go(3, 0.5);
    f.go(6, -1.0);
    f.go(3, 0.5);
  }
  EXPECT_EQ(f.count.bends(), 0);
}

TEST(BendCount, ACourseThatThePassageDoesNotTakeIsNone) {
  Flown f;
  f.go(10);
  f.go(5, kRight, -kRight);
  f.go(10, 0.0, -kRight);
  EXPECT_EQ(f.count.bends(), 0) << "flown across a cavern";
  f.go(10, 0.0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(f.count.bends(), 0) << "no passage is known";
  f.go(10);
  EXPECT_EQ(f.count.bends(), 1);
}

TEST(BendCount, TurningBackIsNone) {
  Flown f;
  f.go(10);
  f.yaw_rad += 2.0 * kRight;
  f.go(10);
  EXPECT_EQ(f.count.bends(), 0);
  f.go(6, kRight);
  f.go(10);
  EXPECT_EQ(f.count.bends(), 1) << "counted from the way back";
}

TEST(BendCount, HoveringInGustsIsNone) {
  BendCount count;
  for (int i = 0; i < 4000; ++i) count.add({0.2 * std::sin(0.05 * i), 0.2 * std::cos(0.031 * i), 1.0}, 0.0);
  EXPECT_EQ(count.bends(), 0);
}

}  // namespace
}  // namespace adit::sim
