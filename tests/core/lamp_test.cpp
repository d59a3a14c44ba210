// The vehicle's own lamp: its pattern learnt from frames, and pairs of frames with it on and off.
#include "adit/lamp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "adit/finder.hpp"
#include "adit/navigator.hpp"
#include "drawn_passage.hpp"

namespace adit {
namespace {

using test::drawn;
using test::Frame;

Camera camera() { return Camera(pinhole(640, 480, 75.0)); }

/// A bell of light over the frame, -2 at the left and right edge; falls less downwards.
double beam_at(int column, int row) {
  const double x = (column + 0.5) / kLampColumns * 2.0 - 1.0, y = ((row + 0.5) / kLampRows * 2.0 - 1.0) * 0.75;
  return -2.0 * x * x - y * y;
}

/// What a frame of a flight shows of it: the beam, rock that is brighter here and darker there and changes with every
/// frame, and an exposure of its own. A dark end of the passage stands in the middle.
LampGlimpse glimpse_of_flight(int frame) {
  LampGlimpse glimpse;
  glimpse.usable = true;
  for (int row = 0; row < kLampRows; ++row) {
    for (int column = 0; column < kLampColumns; ++column) {
      const double rock = -1.0 + 0.8 * std::sin(1.7 * column + 2.3 * frame) * std::cos(1.3 * row - 0.9 * frame);
      const bool far_end = std::abs(column - 9) <= 2 && std::abs(row - 7) <= 2;
      const double light = -3.0 + 0.3 * std::sin(0.5 * frame) + beam_at(column, row) + (far_end ? -4.0 : rock);
      glimpse.log_light[static_cast<std::size_t>(row * kLampColumns + column)] = static_cast<float>(light);
    }
  }
  return glimpse;
}

/// Natural logarithm of the pattern at a place, over its middle.
double over_middle(const LampPattern& pattern, double x, double y) {
  const double tan_half = std::tan(37.5 * 3.14159265358979 / 180.0);
  const auto at = [&](double px, double py) {
    const double flood = std::log1p((px * px + py * py) * tan_half * tan_half);
    const auto& c = pattern.lobe;
    return c[0] + c[1] * px + c[2] * py + c[3] * px * px + c[4] * py * py + c[5] * flood;
  };
  return at(x, y) - at(0.0, 0.0);
}

TEST(LampModel, LearnsTheBeamAndNotTheDarkEndOfThePassage) {
  LampModel model(camera());
  for (int frame = 0; frame < 400; ++frame) model.learn(glimpse_of_flight(frame));
  EXPECT_EQ(model.pattern().frames, 400.0);
  EXPECT_NEAR(over_middle(model.pattern(), 0.9, 0.0), -2.0 * 0.81, 0.35);
  EXPECT_NEAR(over_middle(model.pattern(), -0.9, 0.0), -2.0 * 0.81, 0.35);
  EXPECT_NEAR(over_middle(model.pattern(), 0.0, 0.7), -0.49, 0.35);
}

TEST(LampModel, AVehicleThatHoversLearnsNothing) {
  LampModel model(camera());
  for (int frame = 0; frame < 100; ++frame) model.learn(glimpse_of_flight(7));
  EXPECT_EQ(model.pattern().frames, 1.0);
  LampGlimpse dust = glimpse_of_flight(8);
  dust.usable = false;
  EXPECT_FALSE(model.learn(dust));
  EXPECT_EQ(model.pattern().frames, 1.0);
}

TEST(LampModel, GoesOnFromWhatWasLearntBefore) {
  LampModel first(camera());
  for (int frame = 0; frame < 200; ++frame) first.learn(glimpse_of_flight(frame));
  LampModel second(camera(), first.pattern());
  EXPECT_EQ(second.pattern().lobe, first.pattern().lobe);
  for (int frame = 200; frame < 216; ++frame) second.learn(glimpse_of_flight(frame));
  EXPECT_EQ(second.pattern().frames, 216.0);
  EXPECT_NEAR(over_middle(second.pattern(), 0.9, 0.0), over_middle(first.pattern(), 0.9, 0.0), 0.3);
}

TEST(LampModel, RefusesWhatIsNoBeam) {
  LampPattern valley;
  valley.lobe[3] = 0.5;
  EXPECT_THROW(LampModel(camera(), valley), std::invalid_argument);
  LampPattern broken;
  broken.lobe[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LampModel(camera(), broken), std::invalid_argument);
  LampPattern negative;
  negative.frames = -1.0;
  EXPECT_THROW(LampModel(camera(), negative), std::invalid_argument);
}

TEST(LampInFinder, TakesTheBeamOutOfTheFrame) {
  // The opening stands half outside a narrow beam; without the pattern its dark side is the beam's dark side too.
  const Frame frame = drawn({.openings = {{470, 250, 60, 50}}, .beam_px = 190.0});
  OpenSpaceFinder finder;
  const OpenSpace before = finder.find(frame.view());
  LampPattern beam;  // half of the light lost at 190 px of 320
  beam.lobe = {0.0, 0.0, 0.0, -std::log(2.0) / (0.594 * 0.594), -std::log(2.0) / (0.594 * 0.594), 0.0};
  beam.frames = 1000.0;
  finder.set_lamp(beam);
  const OpenSpace after = finder.find(frame.view());
  ASSERT_TRUE(after.found()) << to_string(after.status);
  const auto error_px = [](const OpenSpace& seen) { return std::abs(seen.centroid_px.u_px - 470.0); };
  EXPECT_LT(error_px(after), 25.0);
  if (before.found()) {
    EXPECT_LE(error_px(after), error_px(before) + 3.0);
    EXPECT_GE(after.confidence, before.confidence - 0.05);
  }
  finder.set_lamp({});
  const OpenSpace again = finder.find(frame.view());
  EXPECT_EQ(again.centroid_px.u_px, before.centroid_px.u_px);
}

TEST(LampInFinder, IsLearntInFlight) {
  NavigatorConfig config;
  Navigator navigator(config, camera());
  navigator.use_lamp({}, true);
  for (int i = 0; i < 30; ++i) {
    const Frame frame = drawn({.openings = {{300.0 + 5 * i, 250, 70, 60}}, .beam_px = 250.0, .seed = 1u + i});
    navigator.update(frame.view(), i / 30.0);
  }
  EXPECT_GE(navigator.lamp().frames, 20.0);
  EXPECT_LT(over_middle(navigator.lamp(), 0.9, 0.0), -0.3);
}

/// Grey levels of two lights together, of which each alone gives a picture.
Frame lit_by_both(const Frame& one, const Frame& other) {
  Frame both = one;
  for (int v = 0; v < one.height; ++v) {
    for (int u = 0; u < one.width; ++u) {
      const auto light = [&](const Frame& frame) {
        return std::pow((*frame.pixel(u, v) + 1.0) / 256.0, FinderConfig().light_gamma);
      };
      const double level = 256.0 * std::pow(light(one) + light(other), 1.0 / FinderConfig().light_gamma) - 1.0;
      *both.pixel(u, v) = static_cast<std::uint8_t>(std::lround(std::min(255.0, level)));
    }
  }
  return both;
}

TEST(Flash, WhatForeignLampsLightCancelsOut) {
  const Frame own = drawn({.openings = {{200, 250, 70, 60}}, .brightness = 120.0});
  // The foreign lamp lights the wall on the left and leaves a dark place on the right that is none of ours.
  const Frame foreign = drawn({.openings = {{480, 240, 90, 80}}, .brightness = 130.0, .seed = 5});
  const Frame both = lit_by_both(own, foreign);
  OpenSpaceFinder finder;
  for (const bool lamp_first : {true, false}) {
    const OpenSpace seen =
        lamp_first ? finder.find_flash(both.view(), foreign.view()) : finder.find_flash(foreign.view(), both.view());
    ASSERT_EQ(seen.status, Status::kFound) << to_string(seen.status);
    EXPECT_EQ(seen.rule, Rule::kFlash);
    EXPECT_NEAR(seen.centroid_px.u_px, 200, 25);
    EXPECT_NEAR(seen.centroid_px.v_px, 250, 25);
  }
}

TEST(Flash, TwoFramesWithoutADifferenceMeanThatTheLampIsOut) {
  const Frame frame = drawn({.openings = {{200, 250, 70, 60}}});
  EXPECT_EQ(OpenSpaceFinder().find_flash(frame.view(), frame.view()).status, Status::kTooDark);
}

TEST(Flash, FramesOfTwoSizesAreNoPair) {
  const Frame one = drawn({.openings = {{200, 250, 70, 60}}});
  const Frame other(320, 240, PixelFormat::kGrey8, 90);
  EXPECT_EQ(OpenSpaceFinder().find_flash(one.view(), other.view()).status, Status::kBadFrame);
}

TEST(Flash, ThePublishedMethodTakesTheBrighterFrame) {
  const Frame lit = drawn({.openings = {{200, 250, 70, 60}}}), dark(640, 480, PixelFormat::kGrey8, 3);
  const OpenSpace expected = OpenSpaceFinder(paper_preset()).find(lit.view());
  const OpenSpace seen = OpenSpaceFinder(paper_preset()).find_flash(dark.view(), lit.view());
  EXPECT_EQ(seen.centroid_px.u_px, expected.centroid_px.u_px);
}

}  // namespace
}  // namespace adit
