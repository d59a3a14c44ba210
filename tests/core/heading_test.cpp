#include "adit/heading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace adit {
namespace {

OpenSpace found_at(double azimuth_rad) {
  OpenSpace seen;
  seen.status = Status::kFound;
  seen.bearing.azimuth_rad = azimuth_rad;
  return seen;
}

OpenSpace not_found() {
  OpenSpace seen;
  seen.status = Status::kNoContrast;
  seen.bearing.azimuth_rad = 1.0;  // must not be looked at
  return seen;
}

HeadingConfig quick() {
  HeadingConfig config;
  config.yaw_acceleration_max_rad_s2 = 1000.0;
  return config;
}

/// The command at 30 frames a second once it no longer changes.
HeadingCommand settled(HeadingController& controller, double azimuth_rad, double from_s = 0.0) {
  HeadingCommand command;
  for (int i = 0; i < 60; ++i) command = controller.update(found_at(azimuth_rad), from_s + i / 30.0);
  return command;
}

TEST(Heading, TheSignTurnsInOnePlace) {
  EXPECT_EQ(yaw_of_azimuth(0.3), -0.3);
  HeadingController controller;
  EXPECT_LT(settled(controller, 0.4).yaw_rate_rad_s, 0.0) << "open space to the right: turn clockwise";
  controller.reset();
  EXPECT_GT(settled(controller, -0.4).yaw_rate_rad_s, 0.0) << "open space to the left: turn counter-clockwise";
}

TEST(Heading, IsProportionalBeyondTheDeadBand) {
  HeadingConfig config = quick();
  config.gain_per_s = 1.5;
  config.dead_band_rad = 0.05;
  HeadingController controller(config);
  const HeadingCommand command = settled(controller, 0.25);
  EXPECT_EQ(command.state, HeadingState::kSteer);
  EXPECT_NEAR(command.yaw_rate_rad_s, -1.5 * 0.20, 1e-12);
  EXPECT_NEAR(settled(controller, -0.25, 2.0).yaw_rate_rad_s, 1.5 * 0.20, 1e-12);
}

TEST(Heading, TheDeadBandHasNoJumpAtItsEdge) {
  HeadingConfig config = quick();
  HeadingController controller(config);
  EXPECT_EQ(settled(controller, config.dead_band_rad).yaw_rate_rad_s, 0.0);
  EXPECT_EQ(settled(controller, -0.5 * config.dead_band_rad, 2.0).yaw_rate_rad_s, 0.0);
  EXPECT_NEAR(settled(controller, config.dead_band_rad + 1e-6, 4.0).yaw_rate_rad_s, -1e-6, 1e-9);
}

TEST(Heading, TheRateIsLimited) {
  HeadingController controller;
  EXPECT_NEAR(settled(controller, 3.0).yaw_rate_rad_s, -controller.config().yaw_rate_max_rad_s, 1e-12);
}

TEST(Heading, TheFirstFrameSteersFromRateZero) {
  HeadingController controller;
  const HeadingCommand command = controller.update(found_at(0.5), 12.0);
  EXPECT_EQ(command.state, HeadingState::kSteer);
  EXPECT_EQ(command.yaw_rate_rad_s, 0.0);
}

TEST(Heading, TheChangeOfTheRateIsLimited) {
  HeadingController controller;
  (void)controller.update(found_at(0.5), 0.0);
  EXPECT_NEAR(controller.update(found_at(0.5), 0.1).yaw_rate_rad_s, -0.2, 1e-12);
  EXPECT_NEAR(controller.update(found_at(-0.5), 0.15).yaw_rate_rad_s, -0.1, 1e-12);
}

TEST(Heading, WithoutABearingTheRateRunsDownAndThenHolds) {
  HeadingController controller;
  double rate = settled(controller, 0.6).yaw_rate_rad_s;
  const double last_found_s = 59.0 / 30.0;
  for (double t = last_found_s + 0.05; t < last_found_s + 0.499; t += 0.05) {
    const HeadingCommand command = controller.update(not_found(), t);
    EXPECT_EQ(command.state, HeadingState::kCoast);
    EXPECT_NEAR(command.yaw_rate_rad_s, std::min(0.0, rate + 0.1), 1e-9);
    rate = command.yaw_rate_rad_s;
  }
  const HeadingCommand held = controller.update(not_found(), last_found_s + 0.5);
  EXPECT_EQ(held.state, HeadingState::kHold);
  EXPECT_EQ(held.yaw_rate_rad_s, 0.0);
}

TEST(Heading, HoldIsExactlyZeroHoweverSlowTheRateMayChange) {
  HeadingConfig config;
  config.yaw_acceleration_max_rad_s2 = 0.5;
  HeadingController controller(config);
  ASSERT_LT(settled(controller, 0.7).yaw_rate_rad_s, -0.5);
  for (double t = 2.0; t < 2.45; t += 0.05) EXPECT_LT(controller.update(not_found(), t).yaw_rate_rad_s, 0.0);
  const HeadingCommand held = controller.update(not_found(), 2.5);
  EXPECT_EQ(held.state, HeadingState::kHold);
  EXPECT_EQ(held.yaw_rate_rad_s, 0.0);
}

TEST(Heading, NeverFoundIsHold) {
  HeadingController controller;
  EXPECT_EQ(controller.tick(5.0).state, HeadingState::kHold);
  EXPECT_EQ(controller.update(not_found(), 5.1).state, HeadingState::kHold);
  EXPECT_EQ(controller.update(not_found(), 5.2).yaw_rate_rad_s, 0.0);
}

TEST(Heading, TheWatchdogCoastsAndHolds) {
  HeadingController controller;
  const double rate = settled(controller, 0.6).yaw_rate_rad_s;
  const double last_s = 59.0 / 30.0;
  const HeadingCommand coasting = controller.tick(last_s + 0.1);
  EXPECT_EQ(coasting.state, HeadingState::kCoast);
  EXPECT_NEAR(coasting.yaw_rate_rad_s, rate + 0.2, 1e-12);
  EXPECT_EQ(controller.tick(last_s + 0.5).state, HeadingState::kHold);
  EXPECT_EQ(controller.tick(last_s + 9.0).yaw_rate_rad_s, 0.0);
}

TEST(Heading, AFrameTakenBeforeTheLastTickIsStillUsed) {
  HeadingController controller;
  (void)settled(controller, 0.6);
  const double last_s = 59.0 / 30.0;
  (void)controller.tick(last_s + 0.10);
  EXPECT_EQ(controller.update(found_at(0.6), last_s + 0.08).state, HeadingState::kSteer);
  EXPECT_EQ(controller.tick(last_s + 0.55).state, HeadingState::kCoast) << "counted from that frame";
}

TEST(Heading, AFrozenCameraIsCoastedOnThenHeldOn) {
  HeadingController controller;
  double rate = std::abs(settled(controller, 0.6).yaw_rate_rad_s);
  HeadingCommand command;
  for (int i = 0; i < 100; ++i) {
    command = controller.update(found_at(0.6), 59.0 / 30.0);  // the same frame for ever
    EXPECT_NE(command.state, HeadingState::kSteer);
    EXPECT_TRUE(std::abs(command.yaw_rate_rad_s) < rate || rate == 0.0);
    rate = std::abs(command.yaw_rate_rad_s);
  }
  EXPECT_EQ(command.state, HeadingState::kHold);
  EXPECT_EQ(command.yaw_rate_rad_s, 0.0);
}

TEST(Heading, ABackwardStampIsStale) {
  HeadingController controller;
  (void)settled(controller, 0.6);
  EXPECT_EQ(controller.update(found_at(0.6), 59.0 / 30.0 - 0.1).state, HeadingState::kCoast);
}

TEST(Heading, ABagThatStartsAgainStartsAfresh) {
  HeadingController controller;
  (void)settled(controller, 0.6);
  const HeadingCommand first = controller.update(found_at(0.6), 0.0);
  EXPECT_EQ(first.state, HeadingState::kSteer);
  EXPECT_EQ(first.yaw_rate_rad_s, 0.0);
  EXPECT_NEAR(controller.update(found_at(0.6), 0.1).yaw_rate_rad_s, -0.2, 1e-12);
}

TEST(Heading, AfterALongGapItStartsFromZero) {
  HeadingController controller;
  (void)settled(controller, 0.6);
  const HeadingCommand first = controller.update(found_at(-0.6), 10.0);
  EXPECT_EQ(first.state, HeadingState::kSteer);
  EXPECT_EQ(first.yaw_rate_rad_s, 0.0);
}

TEST(Heading, WhatIsNoTimeAndNoAzimuthIsNotUsed) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  HeadingController controller;
  EXPECT_EQ(controller.update(found_at(0.6), nan).state, HeadingState::kHold);
  EXPECT_EQ(controller.tick(nan).state, HeadingState::kHold);
  double rate = std::abs(settled(controller, 0.6).yaw_rate_rad_s);
  for (const double bad : {nan, infinity, -infinity}) {
    for (const HeadingCommand command : {controller.update(found_at(0.6), bad), controller.tick(bad)}) {
      EXPECT_EQ(command.state, HeadingState::kCoast);
      EXPECT_LT(std::abs(command.yaw_rate_rad_s), rate);
      rate = std::abs(command.yaw_rate_rad_s);
    }
  }
  EXPECT_EQ(controller.update(found_at(nan), 2.0).state, HeadingState::kCoast);
  EXPECT_TRUE(std::isfinite(controller.update(found_at(0.1), 2.05).yaw_rate_rad_s));
}

TEST(Heading, ResetForgets) {
  HeadingController controller;
  (void)settled(controller, 0.6);
  controller.reset();
  EXPECT_EQ(controller.tick(2.0).state, HeadingState::kHold);
  EXPECT_EQ(controller.update(found_at(0.6), 1.0).yaw_rate_rad_s, 0.0);
}

}  // namespace
}  // namespace adit
