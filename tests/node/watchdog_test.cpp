#include "adit/node/watchdog.hpp"

#include <gtest/gtest.h>

namespace adit::node {
namespace {

constexpr Time_ns kBegin_ns = 1'700'000'000 * kSecond_ns;

/// A robot on a made clock.
struct Robot {
  ControlConfig config;
  Watchdog watchdog{config};

  static Time_ns at(double time_s) { return kBegin_ns + time_of(time_s); }
  void image(double time_s, Status status = Status::kFound, double age_s = 0.01) {
    watchdog.see_image(at(time_s - age_s), status, status == Status::kFound, at(time_s));
    if (status == Status::kFound) watchdog.see_heading(at(time_s));
  }
  WatchdogState check(double time_s) { return watchdog.check(at(time_s)); }
};

TEST(WatchdogTest, BeforeTheFirstImageItHovers) {
  Robot robot;
  EXPECT_EQ(robot.check(0.0).watch, Watch::kHover);
  EXPECT_EQ(robot.check(0.0).alarm, Alarm::kNoImage);
  EXPECT_EQ(robot.check(4.9).watch, Watch::kHover);
  EXPECT_EQ(robot.check(5.1).watch, Watch::kError);
}

TEST(WatchdogTest, ACameraThatStopsIsHoveredOnAfterHalfASecondAndAnErrorAfterFive) {
  Robot robot;
  for (int i = 0; i <= 30; ++i) {
    robot.image(i / 30.0, Status::kFound, 0.0);
    EXPECT_EQ(robot.check(i / 30.0).watch, Watch::kFresh);
  }
  EXPECT_EQ(robot.check(1.49).watch, Watch::kFresh);
  EXPECT_EQ(robot.check(1.50).watch, Watch::kHover);
  EXPECT_EQ(robot.check(1.50).alarm, Alarm::kNoImage);
  EXPECT_EQ(robot.check(5.99).watch, Watch::kHover);
  EXPECT_EQ(robot.check(6.00).watch, Watch::kError);
  EXPECT_NEAR(robot.check(6.25).for_s, 5.25, 1e-6);
  robot.image(7.0);
  EXPECT_EQ(robot.check(7.0).watch, Watch::kFresh) << "it goes on by itself";
}

TEST(WatchdogTest, FreshImagesWithoutAnOpeningAreHoveredOnJustAsSoon) {
  Robot robot;
  robot.image(0.0, Status::kFound, 0.0);
  for (int i = 1; i <= 14; ++i) robot.image(i / 30.0, Status::kNoOpening, 0.0);
  EXPECT_EQ(robot.check(0.49).watch, Watch::kFresh);
  for (int i = 15; i <= 180; ++i) robot.image(i / 30.0, Status::kNoOpening, 0.0);
  EXPECT_EQ(robot.check(6.0).watch, Watch::kError);
  EXPECT_EQ(robot.check(6.0).alarm, Alarm::kNoOpening);
}

TEST(WatchdogTest, AFrozenCameraIsNamed) {
  Robot robot;
  robot.image(0.0);
  for (int i = 1; i <= 30; ++i) robot.image(i / 30.0, Status::kFrozenFrame);
  EXPECT_EQ(robot.check(1.0).watch, Watch::kHover);
  EXPECT_EQ(robot.check(1.0).alarm, Alarm::kFrozen);
}

TEST(WatchdogTest, FreshIsWhenTheImageWasTakenNotWhenItCame) {
  Robot robot;
  robot.image(1.0, Status::kFound, 0.4);
  EXPECT_EQ(robot.check(1.09).watch, Watch::kFresh);
  EXPECT_EQ(robot.check(1.11).watch, Watch::kHover);
}

TEST(WatchdogTest, ImagesOfThePastAndOfTheFutureAreNamedAndCounted) {
  Robot robot;
  for (int i = 0; i < 30; ++i) robot.image(i / 30.0, Status::kFound, 3600.0);
  EXPECT_EQ(robot.check(1.0).watch, Watch::kHover);
  EXPECT_EQ(robot.check(1.0).alarm, Alarm::kOldImages);
  for (int i = 30; i < 60; ++i) robot.image(i / 30.0, Status::kFound, -3600.0);
  EXPECT_EQ(robot.check(2.0).alarm, Alarm::kFutureImages);
  EXPECT_EQ(robot.watchdog.old_images(), 30);
  EXPECT_EQ(robot.watchdog.future_images(), 30);
}

TEST(WatchdogTest, AStampSlightlyInTheFutureBuysNoTime) {
  Robot robot;
  robot.image(1.0, Status::kFound, -0.4);
  EXPECT_EQ(robot.check(1.49).watch, Watch::kFresh);
  EXPECT_EQ(robot.check(1.50).watch, Watch::kHover);
}

TEST(WatchdogTest, AClockSetForwardHoversUntilTheNextImage) {
  Robot robot;
  robot.image(0.0);
  EXPECT_EQ(robot.check(3600.0).watch, Watch::kError);
  robot.image(3600.1);
  EXPECT_EQ(robot.check(3600.1).watch, Watch::kFresh);
}

TEST(WatchdogTest, AClockSetBackForgetsAllThatWasFresh) {
  Robot robot;
  robot.image(100.0);
  EXPECT_EQ(robot.check(100.0).watch, Watch::kFresh);
  EXPECT_EQ(robot.check(1.0).watch, Watch::kHover) << "an image of the time before the jump is no longer fresh";
  EXPECT_EQ(robot.watchdog.clock_jumps_back(), 1);
  EXPECT_EQ(robot.check(5.9).watch, Watch::kHover) << "five seconds are counted from the jump";
  EXPECT_EQ(robot.check(6.0).watch, Watch::kError);
  robot.image(6.1);
  EXPECT_EQ(robot.check(6.1).watch, Watch::kFresh);
}

TEST(WatchdogTest, OpeningsWithoutHeadingsAreAlarming) {
  Robot robot;
  for (int i = 0; i < 30; ++i) robot.watchdog.see_image(Robot::at(i / 30.0), Status::kFound, true, Robot::at(i / 30.0));
  EXPECT_EQ(robot.check(1.0).watch, Watch::kHover);
  EXPECT_EQ(robot.check(1.0).alarm, Alarm::kNoHeading);
}

TEST(WatchdogTest, ATimeThatStandsStillChangesNothing) {
  Robot robot;
  robot.image(1.0);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(robot.check(1.0).watch, Watch::kFresh);
}

}  // namespace
}  // namespace adit::node
