#include "adit/node/control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace adit::node {
namespace {

constexpr Time_ns kBegin_ns = 1'700'000'000 * kSecond_ns;
Time_ns at(double time_s) { return kBegin_ns + time_of(time_s); }

std::optional<VelocityCommand> frame(Control& control, double time_s, double forward_m_s = 0.2, double yaw_rate = 0.1,
                                     Status status = Status::kFound, double latency_s = 0.003) {
  control.take(OpenSpaceNews{at(time_s), status, false}, at(time_s + latency_s));
  return control.take(HeadingNews{at(time_s), forward_m_s, yaw_rate}, at(time_s + latency_s));
}

std::string value_of(const Diagnosis& d, const std::string& key) {
  for (const auto& [name, value] : d.values)
    if (name == key) return value;
  return "(absent)";
}

TEST(ControlTest, AFreshHeadingIsPassedOnAsItIs) {
  Control control;
  const auto command = frame(control, 0.0, 0.2, -0.3);
  ASSERT_TRUE(command);
  EXPECT_FALSE(command->is_hover);
  EXPECT_EQ(command->stamp_ns, at(0.0));
  EXPECT_EQ(command->forward_m_s, 0.2);
  EXPECT_EQ(command->yaw_rate_rad_s, -0.3);
  EXPECT_NEAR(control.latency().figures().max_s, 0.003, 1e-9);
}

TEST(ControlTest, NoCommandIsEverRepeated) {
  Control control;
  ASSERT_TRUE(frame(control, 0.0));
  EXPECT_FALSE(control.tick(at(0.1))) << "between headings there is silence";
  EXPECT_FALSE(control.take(HeadingNews{at(0.0), 0.2, 0.1}, at(0.1))) << "the same heading again";
  EXPECT_FALSE(control.take(HeadingNews{at(-0.1), 0.2, 0.1}, at(0.1))) << "an older one";
  EXPECT_EQ(control.refused_headings(), 2);
}

TEST(ControlTest, AKilledCameraIsHoveredOnAtEveryTickAndReported) {
  Control control;
  for (int i = 0; i <= 30; ++i) ASSERT_TRUE(frame(control, i / 30.0));
  EXPECT_EQ(control.diagnosis(at(1.1)).level, Level::kOk);
  for (double t = 1.5; t < 8.0; t += 0.05) {
    const auto command = control.tick(at(t));
    ASSERT_TRUE(command) << t;
    EXPECT_TRUE(command->is_hover);
    EXPECT_EQ(command->forward_m_s, 0.0);
    EXPECT_EQ(command->yaw_rate_rad_s, 0.0);
  }
  EXPECT_EQ(control.diagnosis(at(8.0)).level, Level::kError);
  EXPECT_EQ(control.hover_count(), 1) << "one hover, however many ticks";
}

TEST(ControlTest, TheDiagnosisIsWarnFromHalfASecondAndErrorFromFive) {
  Control control;
  ASSERT_TRUE(frame(control, 0.0));
  EXPECT_EQ(control.diagnosis(at(0.4)).level, Level::kOk);
  EXPECT_EQ(control.diagnosis(at(0.6)).level, Level::kWarn);
  EXPECT_EQ(control.diagnosis(at(0.6)).message, "hover for 0.6 s: no image");
  EXPECT_EQ(control.diagnosis(at(4.9)).level, Level::kWarn);
  EXPECT_EQ(control.diagnosis(at(5.1)).level, Level::kError);
}

TEST(ControlTest, AHeadingWithoutAnOpeningDoesNotMoveTheVehicle) {
  Control control;
  std::optional<VelocityCommand> command;
  for (int i = 0; i < 30; ++i) command = frame(control, i / 30.0, 0.2, 0.1, Status::kNoOpening);
  ASSERT_TRUE(command);
  EXPECT_TRUE(command->is_hover);
  EXPECT_EQ(control.diagnosis(at(1.0)).message, "hover for 1.0 s: no opening (no_opening)");
}

TEST(ControlTest, AFrozenCameraIsSaidToBeFrozen) {
  Control control;
  for (int i = 0; i < 60; ++i) (void)frame(control, i / 30.0, 0.2, 0.1, i < 3 ? Status::kFound : Status::kFrozenFrame);
  const auto command = control.tick(at(2.0));
  ASSERT_TRUE(command);
  EXPECT_TRUE(command->is_hover);
  EXPECT_NE(control.diagnosis(at(2.0)).message.find("frozen"), std::string::npos);
}

TEST(ControlTest, ATurnAtADeadEndNeedsLeave) {
  ControlConfig config;
  for (const bool allowed : {false, true}) {
    config.turn_without_opening = allowed;
    Control control(config);
    std::optional<VelocityCommand> command;
    for (int i = 0; i < 30; ++i) {
      control.take(OpenSpaceNews{at(i / 30.0), Status::kNoOpening, true}, at(i / 30.0));
      command = control.take(HeadingNews{at(i / 30.0), 0.0, 0.6}, at(i / 30.0));
    }
    ASSERT_TRUE(command);
    EXPECT_EQ(command->is_hover, !allowed);
    EXPECT_EQ(command->yaw_rate_rad_s, allowed ? 0.6 : 0.0);
  }
}

TEST(ControlTest, CommandsStayWithinTheLimits) {
  Control control;
  (void)frame(control, 0.0);
  const auto command = frame(control, 0.03, 50.0, -9.0);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->forward_m_s, control.config().speed_max_m_s);
  EXPECT_EQ(command->yaw_rate_rad_s, -control.config().yaw_rate_limit_rad_s);
  EXPECT_EQ(frame(control, 0.06, -1.0, 0.0)->forward_m_s, 0.0) << "never backwards: nothing looks there";
}

TEST(ControlTest, WhatIsNoNumberIsNoCommand) {
  Control control;
  (void)frame(control, 0.0);
  EXPECT_FALSE(frame(control, 0.03, std::nan(""), 0.1));
  EXPECT_FALSE(frame(control, 0.06, 0.2, std::numeric_limits<double>::infinity()));
}

TEST(ControlTest, AHeadingThatIsLateIsAnsweredByHover) {
  Control control;
  (void)frame(control, 0.0);
  control.take(OpenSpaceNews{at(1.0), Status::kFound, false}, at(1.0));
  const auto command = control.take(HeadingNews{at(0.4), 0.2, 0.1}, at(1.0));
  ASSERT_TRUE(command);
  EXPECT_TRUE(command->is_hover);
}

TEST(ControlTest, DuplicatedImagesAreNoSignOfLife) {
  Control control;
  (void)frame(control, 0.0);
  for (int i = 1; i < 30; ++i) control.take(OpenSpaceNews{at(0.0), Status::kFound, false}, at(i / 30.0));
  const auto command = control.tick(at(1.0));
  ASSERT_TRUE(command);
  EXPECT_TRUE(command->is_hover);
  EXPECT_EQ(value_of(control.diagnosis(at(1.0)), "stamps duplicate"), "29");
}

TEST(ControlTest, ABagThatLoopsIsFollowedAgain) {
  Control control;
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(frame(control, 100.0 + i / 30.0));
  std::optional<VelocityCommand> command;
  for (int i = 0; i < 3; ++i) command = frame(control, i / 30.0);
  ASSERT_TRUE(command);
  EXPECT_FALSE(command->is_hover);
  const Diagnosis d = control.diagnosis(at(0.1));
  EXPECT_EQ(d.level, Level::kOk);
  EXPECT_EQ(value_of(d, "stamps restarted"), "1");
  EXPECT_EQ(value_of(d, "clock set back"), "1");
}

TEST(ControlTest, ABadConfigurationIsRefusedAndTheOldOneStays) {
  Control control;
  ControlConfig bad;
  bad.hover_after_s = 0.0;
  EXPECT_THROW(control.configure(bad), std::invalid_argument);
  EXPECT_EQ(control.config().hover_after_s, 0.5);
  bad = {};
  bad.error_after_s = 0.2;
  EXPECT_THROW(Control{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace adit::node
