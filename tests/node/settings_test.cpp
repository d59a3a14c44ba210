#include "adit/node/settings.hpp"

#include <gtest/gtest.h>

#include <set>

#include "adit/node/launch_config.hpp"

namespace adit::node {
namespace {

TEST(SettingsTest, NoTwoParametersShareAName) {
  for (const auto& parameters : {parameters_of(PerceptionSettings{}), parameters_of(ControlConfig{})}) {
    std::set<std::string> names;
    for (const Parameter& p : parameters) EXPECT_TRUE(names.insert(p.name).second) << p.section << "." << p.name;
    EXPECT_GT(names.size(), 4u);
  }
}

TEST(SettingsTest, EachFieldOfTheFinderIsAParameterOfTheSameName) {
  std::set<std::string> names;
  for (const Parameter& p : parameters_of(PerceptionSettings{})) names.insert(p.name);
  FinderConfig finder;
  visit_fields(finder, [&](const FieldNote& note, auto&) { EXPECT_TRUE(names.contains(note.name)) << note.name; });
}

TEST(SettingsTest, EachParameterTakesItsOwnDefault) {
  PerceptionSettings settings;
  for (const Parameter& p : parameters_of(settings)) EXPECT_EQ(set_parameter(settings, p.name, p.value), "") << p.name;
  ControlConfig control;
  for (const Parameter& p : parameters_of(control)) EXPECT_EQ(set_parameter(control, p.name, p.value), "") << p.name;
}

TEST(SettingsTest, ValuesReachTheStruct) {
  PerceptionSettings settings;
  EXPECT_EQ(set_parameter(settings, "omega", 0.5), "");
  EXPECT_EQ(settings.navigator.finder.omega, 0.5);
  EXPECT_EQ(set_parameter(settings, "omega", 1), "") << "YAML writes 1 for 1.0";
  EXPECT_EQ(settings.navigator.finder.omega, 1.0);
  EXPECT_EQ(set_parameter(settings, "cluster_count", 5.0), "");
  EXPECT_EQ(settings.navigator.finder.cluster_count, 5);
  EXPECT_EQ(set_parameter(settings, "method", std::string("adit")), "");
  EXPECT_EQ(settings.navigator.finder.method, Method::kAdit);
  EXPECT_EQ(set_parameter(settings, "pilot", std::string("published")), "");
  EXPECT_EQ(settings.node.pilot, Pilot::kPublished);
  ControlConfig control;
  EXPECT_EQ(set_parameter(control, "turn_without_opening", true), "");
  EXPECT_TRUE(control.turn_without_opening);
}

TEST(SettingsTest, WhatIsRefusedIsNamedAndLeavesNoTrace) {
  PerceptionSettings settings;
  EXPECT_EQ(set_parameter(settings, "omega", 9.0), "omega: 9 is not in [0.01, 1]; set a value in this range");
  EXPECT_EQ(settings.navigator.finder.omega, FinderConfig().omega);
  EXPECT_EQ(set_parameter(settings, "method", std::string("magic")),
            "method: 'magic' is not known; set one of paper, adit");
  EXPECT_EQ(set_parameter(settings, "cluster_count", 5.5),
            "cluster_count: a value of the wrong type; set a whole number");
  EXPECT_EQ(set_parameter(settings, "omgea", 0.5), "omgea: there is no such parameter");
  EXPECT_NE(set_parameter(settings, "patch_size_px", 4), "") << "even: no middle pixel";
  EXPECT_EQ(settings.navigator.finder.patch_size_px, FinderConfig().patch_size_px);
  EXPECT_NE(set_parameter(settings, "omega", std::string("much")), "");
  EXPECT_NE(set_parameter(settings, "omega", true), "");
  ControlConfig control;
  EXPECT_NE(set_parameter(control, "error_after_s", 0.1), "") << "shorter than hover_after_s";
  EXPECT_EQ(control.error_after_s, 5.0);
}

TEST(LaunchConfigTest, ValuesReachTheStructAndWhatIsRefusedIsNamed) {
  CameraLaunch camera;
  EXPECT_EQ(set_parameter(camera, "input", std::string("/dev/video0")), "");
  EXPECT_EQ(set_parameter(camera, "rate_hz", 15), "");
  EXPECT_EQ(camera.input, "/dev/video0");
  EXPECT_EQ(camera.rate_hz, 15.0);
  EXPECT_EQ(set_parameter(camera, "rate_hz", 0.0), "rate_hz: 0 Hz is not in [0.1, 1000] Hz; set a value in this range");
  EXPECT_EQ(set_parameter(camera, "input", 0), "input: a value of the wrong type; set text");
  EXPECT_EQ(camera.rate_hz, 15.0);
  SimLaunch sim;
  EXPECT_EQ(set_parameter(sim, "seed", 7), "");
  EXPECT_EQ(set_parameter(sim, "lockstep", true), "");
  EXPECT_EQ(sim.robot.seed, 7u);
  EXPECT_TRUE(sim.lockstep);
  EXPECT_NE(set_parameter(sim, "dust_1_m", 2.0), "");
  EXPECT_EQ(set_parameter(sim, "nobody", 2.0), "nobody: there is no such parameter");
}

TEST(LaunchConfigTest, EachParameterTakesItsOwnDefault) {
  const auto check = [](auto launch) {
    for (const Parameter& p : parameters_of(launch)) EXPECT_EQ(set_parameter(launch, p.name, p.value), "") << p.name;
  };
  check(PerceptionLaunch{});
  check(ControlLaunch{});
  check(CameraLaunch{});
  check(SimLaunch{});
}

}  // namespace
}  // namespace adit::node
