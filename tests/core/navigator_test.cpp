#include "adit/navigator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lit_plan.hpp"

namespace adit {
namespace {

using test::LitPlan;
using test::PlanFlight;
using test::PlanPose;

constexpr double kFrame_s = 0.05;

LitPlan straight(double width_m, double length_m = 80.0) {
  LitPlan plan;
  plan.add_passage({{-10, 0}, {length_m, 0}}, width_m, false, false);
  return plan;
}

/// 6 m wide, 20 m of S, as in the paper's mine.
LitPlan s_bend() {
  LitPlan plan;
  plan.add_passage({{-5, 0}, {6, 0}, {10, 1.3}, {14, 4.6}, {17, 8.6}, {21, 11.9}, {25, 13.2}, {60, 13.2}}, 6.0, false,
                   false);
  return plan;
}

LitPlan dead_end() {
  LitPlan plan;
  plan.add_passage({{-40, 0}, {15, 0}}, 5.0, true, false);
  return plan;
}

PlanFlight flight(const LitPlan& plan, PlanPose start, const NavigatorConfig& config = {}) {
  return PlanFlight(plan, start, config);
}

TEST(ColumnRange, RangesOfALitPassageAreRightWithinAQuarter) {
  const LitPlan plan = straight(5.0);
  for (const double y_m : {-1.0, 0.0, 0.8}) {
    const PlanPose pose{0, y_m, 0.1};
    ColumnRange column_range({}, 75.0, 16);
    const RangeProfile profile = column_range.measure(plan.seen_from(pose, 1, 320, 240).view());
    ASSERT_TRUE(profile.valid);
    for (int bin = 0; bin < kRangeBins; ++bin) {
      const double range_m = plan.pseudo_range_m(pose, profile.azimuth_rad(bin));
      if (range_m > 8.0) continue;  // floor and roof come into the band
      EXPECT_NEAR(profile.range_m[static_cast<std::size_t>(bin)] / range_m, 1.0, 0.25) << bin << ' ' << range_m;
    }
  }
}

TEST(ColumnRange, ItsScaleDoesNotDependOnTheExposureNorOnTheFormat) {
  LitPlan plan = straight(5.0);
  const test::Frame frame = plan.seen_from({0, 0.5, 0}, 0, 320, 240);
  test::Frame dim = frame;
  for (auto& level : dim.bytes) level = static_cast<std::uint8_t>(std::lround(0.7 * level));
  ColumnRange column_range({}, 75.0, 16);
  const RangeProfile bright = column_range.measure(frame.view());
  const RangeProfile dark = column_range.measure(dim.view());
  const RangeProfile bgr = column_range.measure(test::in_format(frame, PixelFormat::kBgr8).view());
  const RangeProfile deep = column_range.measure(test::in_format(frame, PixelFormat::kGrey16).view());
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    EXPECT_NEAR(dark.range_m[bin] / bright.range_m[bin], 1.0, 0.1) << bin;
    EXPECT_EQ(bgr.range_m[bin], bright.range_m[bin]);
    EXPECT_EQ(deep.range_m[bin], bright.range_m[bin]);
  }
}

TEST(ColumnRange, OfBlackAndOfNoFrameThereIsNone) {
  ColumnRange column_range({}, 75.0, 16);
  EXPECT_FALSE(column_range.measure(test::Frame(80, 60, PixelFormat::kGrey8).view()).valid);
  EXPECT_FALSE(column_range.measure(ImageView{}).valid);
}

TEST(Navigator, CommandsOfAMirroredWorldAreMirrored) {
  const LitPlan plan = s_bend(), other = plan.mirrored();
  PlanFlight a = flight(plan, {0, 1.0, 0.1}), b = flight(other, {0, -1.0, -0.1});
  for (int i = 0; i < 120; ++i) {
    // The noise is not mirrored: the same frame, turned round, is.
    const test::Frame frame = plan.seen_from(a.pose, 7);
    a.command = a.navigator.update(frame.view(), i * kFrame_s, {a.yaw_rate_rad_s, 1.0});
    b.command = b.navigator.update(test::mirrored(frame).view(), i * kFrame_s, {-a.yaw_rate_rad_s, 1.0});
    ASSERT_NEAR(a.command.heading.yaw_rate_rad_s, -b.command.heading.yaw_rate_rad_s, 0.02) << i;
    ASSERT_NEAR(a.command.speed_scale, b.command.speed_scale, 0.05) << i;
    a.yaw_rate_rad_s = a.command.heading.yaw_rate_rad_s;
    a.pose.yaw_rad += kFrame_s * a.yaw_rate_rad_s;
    a.pose.x_m += kFrame_s * std::cos(a.pose.yaw_rad);
    a.pose.y_m += kFrame_s * std::sin(a.pose.yaw_rad);
  }
}

TEST(Navigator, TurnsAwayFromTheNearerWall) {
  for (const double aside_m : {-1.3, 1.3}) {
    const LitPlan plan = straight(5.0);
    Navigator navigator;
    NavigatorCommand command;
    for (int i = 0; i < 20; ++i)
      command = navigator.update(plan.seen_from({0, aside_m, 0}, 1 + static_cast<unsigned>(i)).view(), i * kFrame_s);
    // y is to the left: a vehicle on the left goes right, which is a negative yaw rate.
    EXPECT_LT(command.heading.yaw_rate_rad_s * aside_m, -0.01) << aside_m;
    EXPECT_GT(command.target_rad * aside_m, 0.0) << aside_m;
    EXPECT_EQ(to_string(command.manoeuvre), "follow");
    EXPECT_GT(command.speed_scale, 0.5);
  }
}

TEST(Navigator, FindsTheMiddleOfAPassageAndStaysThere) {
  for (const double width_m : {2.0, 4.0, 6.0}) {
    const LitPlan plan = straight(width_m);
    PlanFlight f = flight(plan, {0, 0.3 * width_m - 0.2, 0.0});
    while (f.time_s < 25.0) f.step();
    EXPECT_LT(std::abs(f.pose.y_m), 0.15 * width_m) << width_m;
    EXPECT_GT(f.pose.x_m, 18.0) << width_m;
    EXPECT_GT(f.clearance_min_m, 0.15 * width_m) << width_m;
  }
}

TEST(Navigator, FliesThroughAnSBendInTheMiddle) {
  const LitPlan plan = s_bend();
  PlanFlight f = flight(plan, {0, -0.5, 0.1});
  while (f.time_s < 60.0 && f.pose.x_m < 32.0) f.step();
  EXPECT_GE(f.pose.x_m, 32.0);
  EXPECT_GT(f.clearance_min_m, 1.5);
  EXPECT_LT(f.time_s, 45.0);
}

TEST(Navigator, TurnsRoundAtADeadEndAndComesOut) {
  const LitPlan plan = dead_end();
  PlanFlight f = flight(plan, {0, 0.3, 0.05});
  bool turned = false;
  while (f.time_s < 90.0 && f.pose.x_m > -12.0) {
    f.step();
    turned = turned || f.command.manoeuvre == Manoeuvre::kTurn;
  }
  EXPECT_TRUE(turned);
  EXPECT_LE(f.pose.x_m, -12.0);
  EXPECT_GT(f.clearance_min_m, 0.6);
  EXPECT_NEAR(std::abs(f.turned_rad), std::numbers::pi, 0.6);
}

// A gap of black rock, as ranges from brightness see it, where all frames say that there is none.
TEST(Navigator, DoesNotCreepForLongIntoWhatTheFramesRefuse) {
  const auto seconds_until_turn = [](Status status, double confidence) {
    Navigator navigator{NavigatorConfig{}};
    Sight sight;
    sight.open_space.status = status;
    sight.open_space.confidence = confidence;
    sight.profile.valid = true;
    sight.profile.azimuth_first_rad = -0.65;
    sight.profile.azimuth_step_rad = 1.3 / (kRangeBins - 1);
    sight.profile.range_m.fill(2.9f);
    double time_s = 0.0;
    while (time_s < 20.0 && navigator.steer(sight, time_s, {0.0, 0.0}).manoeuvre != Manoeuvre::kTurn) time_s += 0.05;
    return time_s;
  };
  const double refused_s = seconds_until_turn(Status::kNoOpening, 0.0);
  EXPECT_GT(refused_s, 3.0);
  EXPECT_LT(refused_s, 6.0);
  EXPECT_GE(seconds_until_turn(Status::kFound, 0.9), 20.0);
}

TEST(Navigator, InAClosedRoomItTurnsOnceRoundAndGivesUp) {
  LitPlan plan;
  plan.add_passage({{-1.2, 0}, {1.2, 0}}, 2.4, true, true);
  PlanFlight f = flight(plan, {0, 0, 0});
  while (f.time_s < 30.0 && f.command.manoeuvre != Manoeuvre::kGiveUp) f.step();
  EXPECT_EQ(to_string(f.command.manoeuvre), "give_up");
  for (int i = 0; i < 20; ++i) f.step();
  EXPECT_EQ(f.command.heading.state, HeadingState::kHold);
  EXPECT_EQ(f.command.speed_scale, 0.0);
  EXPECT_GT(f.clearance_min_m, 0.3);
}

TEST(Navigator, PrefersTheSideItIsToldTo) {
  // A drift that forks, 40 degrees to either side.
  LitPlan plan;
  plan.walls = {{{-10, 2}, {12, 2}},     {{-10, -2}, {12, -2}}, {{12, 2}, {32, 18.8}},
                {{12, -2}, {32, -18.8}}, {{16, 0}, {36, 16.8}}, {{16, 0}, {36, -16.8}}};
  for (const Prefer prefer : {Prefer::kLeft, Prefer::kRight}) {
    NavigatorConfig config;
    config.steering.prefer = prefer;
    PlanFlight f = flight(plan, {0, 0, 0}, config);
    while (f.time_s < 40.0 && std::abs(f.pose.y_m) < 6.0) f.step();
    EXPECT_GT(prefer == Prefer::kLeft ? f.pose.y_m : -f.pose.y_m, 5.9) << to_string(prefer);
    EXPECT_GT(f.clearance_min_m, 0.6) << to_string(prefer);
  }
}

TEST(Navigator, TakesACrossingDriftOnTheSideItIsToldTo) {
  // Two drifts of 5 m that cross: the way ahead is always the longer one.
  LitPlan plan;
  for (const double side : {-1.0, 1.0}) {
    plan.walls.push_back({{-10, 2.5 * side}, {15, 2.5 * side}});
    plan.walls.push_back({{15, 2.5 * side}, {15, 40 * side}});
    plan.walls.push_back({{20, 2.5 * side}, {20, 40 * side}});
    plan.walls.push_back({{20, 2.5 * side}, {60, 2.5 * side}});
  }
  const auto flown = [&plan](Prefer prefer) {
    NavigatorConfig config;
    config.steering.prefer = prefer;
    PlanFlight f = flight(plan, {0, 0, 0}, config);
    while (f.time_s < 60.0 && std::abs(f.pose.y_m) < 12.0 && f.pose.x_m < 32.0) f.step();
    EXPECT_GT(f.clearance_min_m, 0.6) << to_string(prefer);
    return f.pose;
  };
  EXPECT_GE(flown(Prefer::kStraight).x_m, 32.0);
  EXPECT_GE(flown(Prefer::kLeft).y_m, 12.0);
  EXPECT_LE(flown(Prefer::kRight).y_m, -12.0);
  EXPECT_LE(flown(Prefer::kExplore).y_m, -12.0);
}

TEST(Navigator, OneBadFrameDoesNotTurnTheVehicle) {
  const LitPlan plan = straight(5.0);
  const LitPlan wall = [] {
    LitPlan p;
    p.add_passage({{-5, 0}, {2.2, 0}}, 5.0, true, false);
    return p;
  }();
  Navigator navigator;
  double largest = 0.0;
  for (int i = 0; i < 100; ++i) {
    const bool bad = i == 40 || i == 70;
    const test::Frame frame = i == 55 ? test::noise(80, 60, PixelFormat::kGrey8, 3)
                                      : (bad ? wall : plan).seen_from({0, 0, 0}, 1 + static_cast<unsigned>(i));
    const NavigatorCommand command = navigator.update(frame.view(), i * kFrame_s, {0.0, 1.0});
    if (i > 20) largest = std::max(largest, std::abs(command.heading.yaw_rate_rad_s));
    EXPECT_NE(to_string(command.manoeuvre), "turn") << i;
  }
  EXPECT_LT(largest, 0.15);
}

TEST(Navigator, HoldsAfterHalfASecondWithoutFrames) {
  const LitPlan plan = straight(5.0);
  Navigator navigator;
  for (int i = 0; i < 20; ++i)
    (void)navigator.update(plan.seen_from({0, 1, 0}, 1 + static_cast<unsigned>(i)).view(), i * kFrame_s);
  const double last_s = 19 * kFrame_s;
  EXPECT_EQ(navigator.tick(last_s + 0.2).heading.state, HeadingState::kCoast);
  EXPECT_GT(navigator.tick(last_s + 0.3).speed_scale, 0.0);
  const NavigatorCommand held = navigator.tick(last_s + 0.51);
  EXPECT_EQ(held.heading.state, HeadingState::kHold);
  EXPECT_EQ(held.heading.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(held.speed_scale, 0.0);
  EXPECT_EQ(to_string(held.manoeuvre), "wait");
}

TEST(Navigator, NoCommandComesOfStaleFrames) {
  const LitPlan plan = straight(5.0);
  Navigator navigator;
  for (int i = 0; i < 20; ++i)
    (void)navigator.update(plan.seen_from({0, 1.3, 0}, 1 + static_cast<unsigned>(i)).view(), i * kFrame_s);
  NavigatorCommand command;
  for (int i = 0; i < 60; ++i) {
    command = navigator.update(plan.seen_from({0, -1.3, 0}, 50 + static_cast<unsigned>(i)).view(), 19 * kFrame_s);
    EXPECT_EQ(to_string(command.stamp_fault), "not_later");
    EXPECT_NE(command.heading.state, HeadingState::kSteer);
  }
  EXPECT_EQ(command.heading.state, HeadingState::kHold);
  EXPECT_EQ(command.speed_scale, 0.0);
}

TEST(Navigator, StampsThatJumpAreNamedAndSurvived) {
  const LitPlan plan = straight(5.0);
  Navigator navigator;
  unsigned seed = 1;
  const auto at = [&](double stamp_s) { return navigator.update(plan.seen_from({0, 0, 0}, seed++).view(), stamp_s); };
  EXPECT_EQ(at(100.0).stamp_fault, StampFault::kNone);
  EXPECT_EQ(at(100.05).stamp_fault, StampFault::kNone);
  EXPECT_EQ(at(100.04).stamp_fault, StampFault::kNotLater);
  EXPECT_EQ(at(std::numeric_limits<double>::quiet_NaN()).stamp_fault, StampFault::kNotLater);
  EXPECT_EQ(at(3.0).stamp_fault, StampFault::kBackwards);
  EXPECT_EQ(at(3.05).stamp_fault, StampFault::kNone);
  const NavigatorCommand jump = at(1e6);
  EXPECT_EQ(jump.stamp_fault, StampFault::kJump);
  EXPECT_EQ(jump.heading.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(at(1e6 + 0.05).heading.state, HeadingState::kSteer);
}

TEST(Navigator, FrozenAndTornFramesAreNamedWithinThreeAndHeldOn) {
  const LitPlan plan = straight(5.0);
  Navigator navigator;
  int i = 0;
  for (; i < 20; ++i)
    (void)navigator.update(plan.seen_from({0.05 * i, 1, 0}, 1 + static_cast<unsigned>(i)).view(), i * kFrame_s);
  const test::Frame hung = plan.seen_from({1, 1, 0}, 99);
  NavigatorCommand command;
  for (int k = 0; k < 3; ++k) command = navigator.update(hung.view(), i++ * kFrame_s);
  EXPECT_EQ(to_string(command.status), "frozen_frame");
  for (int k = 0; k < 12; ++k) command = navigator.update(hung.view(), i++ * kFrame_s);
  EXPECT_EQ(command.heading.state, HeadingState::kHold);
  EXPECT_EQ(command.speed_scale, 0.0);
}

TEST(Navigator, ConfigurationsAreRefusedByName) {
  NavigatorConfig config;
  config.steering.look_ahead_m = -1;
  EXPECT_THROW(Navigator{config}, std::invalid_argument);
  config = {};
  config.column_range.display_gamma = 0;
  EXPECT_THROW(Navigator{config}, std::invalid_argument);
}

TEST(Navigator, ExplainsAFrameAndAnswersAsWithoutExplaining) {
  const LitPlan plan = s_bend();
  Navigator plain, explained;
  for (int i = 0; i < 5; ++i) {
    const auto frame = plan.seen_from({i * 0.1, 0.2, 0.05}, static_cast<unsigned>(i), 160, 120);
    StageImages images;
    const Sight a = plain.look(frame.view()), b = explained.look(frame.view(), images);
    EXPECT_EQ(images.closing_level.size(), 160u * 120u);
    EXPECT_EQ(a.open_space.status, b.open_space.status);
    EXPECT_EQ(a.open_space.point.sx, b.open_space.point.sx);
    EXPECT_EQ(a.profile.range_m, b.profile.range_m);
  }
}

}  // namespace
}  // namespace adit
