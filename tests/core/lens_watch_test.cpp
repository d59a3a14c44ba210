#include "adit/lens_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "adit/navigator.hpp"
#include "lit_plan.hpp"

namespace adit {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// A black disc with a soft edge, at the same place of every frame.
void soil(test::Frame& frame, double u_px = 116.0, double v_px = 28.0, double radius_px = 12.0) {
  for (int v = 0; v < frame.height; ++v)
    for (int u = 0; u < frame.width; ++u) {
      const double passed = std::clamp((std::hypot(u - u_px, v - v_px) - radius_px) / 6.0 + 0.5, 0.02, 1.0);
      std::uint8_t* const pixel = frame.pixel(u, v);
      for (int c = 0; c < bytes_per_pixel(frame.format); ++c)
        pixel[c] = static_cast<std::uint8_t>(pixel[c] * std::pow(passed, 1.0 / 2.2));
    }
}

test::LitPlan straight() {
  test::LitPlan plan;
  plan.add_passage({{-5, 0}, {60, 0}}, 4.0, false, false);
  return plan;
}

/// Half a circle to the left of this radius about (0, radius), and a straight before it.
test::LitPlan curve(double radius_m, double width_m) {
  std::vector<test::PlanPoint> line = {{-10, 0}};
  for (int i = 0; i <= 60; ++i) {
    const double angle = std::numbers::pi * i / 60.0;
    line.push_back({radius_m * std::sin(angle), radius_m - radius_m * std::cos(angle)});
  }
  test::LitPlan plan;
  plan.add_passage(line, width_m, false, false);
  return plan;
}

/// A vehicle that wags its nose from side to side while it goes straight on.
struct Wag {
  explicit Wag(double swing) : swing_rad(swing) {}
  test::PlanPose pose_at(int i) const { return {0.05 * i, 0.3, swing_rad * std::sin(0.12 * i)}; }
  double swing_rad;
};

/// @return the frame at which dirt was first named; -1: at none.
int frames_until_named(LensWatch& watch, const test::LitPlan& plan, const Wag& wag, bool dirty, int frames = 300) {
  for (int i = 0; i < frames; ++i) {
    test::Frame frame = plan.seen_from(wag.pose_at(i), static_cast<unsigned>(i + 1), kWidth, kHeight);
    if (dirty) soil(frame);
    if (i > 0) watch.turn(wag.pose_at(i).yaw_rad - wag.pose_at(i - 1).yaw_rad);
    watch.look(frame.view());
    if (!watch.spots().empty()) return i;
  }
  return -1;
}

TEST(LensWatch, DirtIsNamedWhileTheVehicleTurns) {
  LensWatch watch({}, 75.0, 16);
  EXPECT_GT(frames_until_named(watch, straight(), Wag(0.25), true), 5);
  ASSERT_EQ(watch.spots().size(), 1u);
  const DirtSpot& spot = watch.spots()[0];
  EXPECT_NEAR(0.5 * (spot.left + spot.right), 58.0, 1.5);
  EXPECT_NEAR(0.5 * (spot.top + spot.bottom), 14.0, 1.5);
}

TEST(LensWatch, NothingIsKnownWithoutATurn) {
  LensWatch watch({}, 75.0, 16);
  EXPECT_EQ(frames_until_named(watch, straight(), Wag(0.0), true), -1);
  EXPECT_EQ(frames_until_named(watch, straight(), Wag(0.06), true), -1);
}

TEST(LensWatch, APassageStraightAheadIsNone) {
  for (const double swing_rad : {0.0, 0.06, 0.12, 0.25, 0.5}) {
    LensWatch watch({}, 75.0, 16);
    EXPECT_EQ(frames_until_named(watch, straight(), Wag(swing_rad), false), -1) << swing_rad;
  }
}

/// Walls without any relief, steered without any error: the way on stands still in the frame while the vehicle turns by
/// 140 degrees.
TEST(LensWatch, ASteadyCurveIsNone) {
  for (const double radius_m : {6.0, 10.0, 20.0, 40.0})
    for (const auto& [width_m, wag_rad] :
         {std::pair{2.5, 0.0}, {4.0, 0.0}, {6.0, 0.0}, {2.5, 0.05}, {4.0, 0.05}, {4.0, 0.1}}) {
      const test::LitPlan plan = curve(radius_m, width_m);
      LensWatch watch({}, 75.0, 16);
      double yaw_before_rad = 0.0;
      for (int i = 0; i < 120; ++i) {
        const double angle = 0.02 * i, yaw_rad = angle + wag_rad * std::sin(0.7 * i);
        const test::PlanPose pose{radius_m * std::sin(angle), radius_m - radius_m * std::cos(angle), yaw_rad};
        watch.turn(yaw_rad - yaw_before_rad);
        yaw_before_rad = yaw_rad;
        watch.look(plan.seen_from(pose, static_cast<unsigned>(i + 1), kWidth, kHeight).view());
        ASSERT_TRUE(watch.spots().empty())
            << radius_m << " m, " << width_m << " m wide, wag " << wag_rad << ", frame " << i;
      }
    }
}

TEST(LensWatch, DirtThatIsWipedOffIsForgotten) {
  LensWatch watch({}, 75.0, 16);
  ASSERT_GE(frames_until_named(watch, straight(), Wag(0.25), true), 0);
  for (int i = 0; i < 12; ++i)
    watch.look(straight().seen_from({0, 0.3, 0.1}, static_cast<unsigned>(i + 1), kWidth, kHeight).view());
  EXPECT_TRUE(watch.spots().empty());
}

TEST(LensWatch, TheNextOpeningBecomesTheBest) {
  LensWatch watch({}, 75.0, 16);
  ASSERT_GE(frames_until_named(watch, straight(), Wag(0.25), true), 0);
  OpenSpace seen;
  seen.status = Status::kFound;
  seen.rule = Rule::kEnclosed;
  seen.opening_count = 2;
  Opening& dirt = seen.openings[0];
  dirt.top_left_px = {104, 16};
  dirt.bottom_right_px = {127, 39};
  dirt.confidence = 0.9;
  Opening& way = seen.openings[1];
  way.top_left_px = {40, 40};
  way.bottom_right_px = {70, 75};
  way.bearing.azimuth_rad = -0.2;
  way.confidence = 0.8;
  watch.take_out(seen);
  EXPECT_TRUE(seen.flags.dirty_lens);
  EXPECT_EQ(seen.opening_count, 1);
  EXPECT_TRUE(seen.found());
  EXPECT_EQ(seen.bearing.azimuth_rad, -0.2);
  EXPECT_EQ(seen.confidence, 0.8);
  seen.openings[0] = dirt = Opening{};
  seen.openings[0].top_left_px = {104, 16};
  seen.openings[0].bottom_right_px = {127, 39};
  watch.take_out(seen);
  EXPECT_EQ(seen.status, Status::kNoOpening);
  EXPECT_EQ(seen.opening_count, 0);
  EXPECT_EQ(seen.confidence, 0.0);
}

TEST(LensWatch, TheNavigatorSaysSo) {
  const test::LitPlan plan = straight();
  const Wag wag(0.25);
  Navigator navigator;
  bool is_named = false;
  for (int i = 0; i < 300; ++i) {
    test::Frame frame = plan.seen_from(wag.pose_at(i), static_cast<unsigned>(i + 1), kWidth, kHeight);
    soil(frame);
    const double rate_rad_s = (wag.pose_at(i).yaw_rad - wag.pose_at(std::max(i - 1, 0)).yaw_rad) / 0.05;
    const Sight sight = navigator.look(frame.view());
    navigator.steer(sight, 0.05 * i, {rate_rad_s, 1.0});
    is_named = is_named || sight.open_space.flags.dirty_lens;
    if (is_named && sight.open_space.found()) {
      EXPECT_GT(std::hypot(sight.open_space.centroid_px.u_px - 116.0, sight.open_space.centroid_px.v_px - 28.0), 6.0)
          << i;
    }
  }
  EXPECT_TRUE(is_named);
  navigator.reset();
  EXPECT_TRUE(navigator.lens_watch().spots().empty());
}

TEST(LensWatch, RefusesWhatIsOutOfRange) {
  LensWatchConfig config;
  config.rim_rad = 0.0;
  EXPECT_THROW(LensWatch(config, 75.0, 16), std::invalid_argument);
}

}  // namespace
}  // namespace adit
