// What must hold between the answers of the method `adit` to two frames that are related.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adit/finder.hpp"
#include "drawn_passage.hpp"

namespace adit {
namespace {

using test::Frame;

/// Half of one degree of a common lens at 640 px: what rounding to whole levels and cells may move a bearing.
constexpr double kRounding_px = 4.0;

OpenSpace seen_in(const Frame& frame) { return OpenSpaceFinder().find(frame.view()); }

/// An opening somewhere else each time, in rock and a beam of its own.
std::vector<test::DrawnScene> scenes() {
  std::vector<test::DrawnScene> out;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    test::DrawnScene scene;
    scene.openings = {{140.0 + 60.0 * seed, 250.0 - 12.0 * seed, 45.0 + 8.0 * seed, 60.0}};
    scene.brightness = 110.0;
    scene.beam_px = 400.0 + 60.0 * seed;
    scene.seed = seed;
    out.push_back(scene);
  }
  return out;
}

void expect_same_answer(const OpenSpace& a, const OpenSpace& b, double tolerance_px) {
  ASSERT_EQ(a.status, Status::kFound);
  ASSERT_EQ(b.status, Status::kFound);
  EXPECT_EQ(a.opening_count, b.opening_count);
  EXPECT_NEAR(a.centroid_px.u_px, b.centroid_px.u_px, tolerance_px);
  EXPECT_NEAR(a.centroid_px.v_px, b.centroid_px.v_px, tolerance_px);
  EXPECT_NEAR(a.confidence, b.confidence, 0.1);
}

TEST(AditProperties, LightByAnyFactorMovesTheAnswerByTheRoundingOnly) {
  for (const test::DrawnScene& scene : scenes()) {
    const Frame frame = test::drawn(scene);
    const OpenSpace seen = seen_in(frame);
    for (const double factor : {0.5, 0.7, 1.4, 1.9}) {
      Frame scaled = frame;
      for (std::uint8_t& level : scaled.bytes) level = static_cast<std::uint8_t>(std::lround(factor * level));
      ASSERT_LT(*std::max_element(scaled.bytes.begin(), scaled.bytes.end()), 255);
      SCOPED_TRACE(testing::Message() << "seed " << scene.seed << ", light by " << factor);
      expect_same_answer(seen, seen_in(scaled), kRounding_px);
    }
  }
}

TEST(AditProperties, WhereTheOpeningIsMovedTheAnswerMoves) {
  for (test::DrawnScene scene : scenes()) {
    const OpenSpace seen = seen_in(test::drawn(scene));
    scene.openings[0].u_px += 24.0;  // whole cells
    const OpenSpace moved = seen_in(test::drawn(scene));
    ASSERT_EQ(seen.status, Status::kFound);
    ASSERT_EQ(moved.status, Status::kFound);
    EXPECT_NEAR(moved.centroid_px.u_px - seen.centroid_px.u_px, 24.0, 2.0 * kRounding_px) << "seed " << scene.seed;
    EXPECT_NEAR(moved.centroid_px.v_px, seen.centroid_px.v_px, 2.0 * kRounding_px) << "seed " << scene.seed;
  }
}

TEST(AditProperties, EveryPixelTwiceIsTheSameSight) {
  for (const test::DrawnScene& scene : scenes()) {
    const Frame frame = test::drawn(scene);
    Frame twice(2 * frame.width, 2 * frame.height, frame.format);
    for (int v = 0; v < twice.height; ++v)
      for (int u = 0; u < twice.width; ++u) *twice.pixel(u, v) = *frame.pixel(u / 2, v / 2);
    OpenSpace doubled = seen_in(twice);
    doubled.centroid_px = {(doubled.centroid_px.u_px - 0.5) / 2.0, (doubled.centroid_px.v_px - 0.5) / 2.0};
    SCOPED_TRACE(testing::Message() << "seed " << scene.seed);
    expect_same_answer(seen_in(frame), doubled, kRounding_px);
  }
}

TEST(AditProperties, GreyIsTheSameInEveryFormat) {
  for (const test::DrawnScene& scene : scenes()) {
    const Frame frame = test::drawn(scene);
    const OpenSpace seen = seen_in(frame);
    for (const PixelFormat format : {PixelFormat::kBgr8, PixelFormat::kRgba8, PixelFormat::kGrey16}) {
      const OpenSpace other = seen_in(test::in_format(frame, format));
      EXPECT_EQ(other.status, seen.status);
      EXPECT_EQ(other.centroid_px.u_px, seen.centroid_px.u_px);
      EXPECT_EQ(other.centroid_px.v_px, seen.centroid_px.v_px);
      EXPECT_EQ(other.confidence, seen.confidence);
    }
  }
}

TEST(AditProperties, ABlackBorderTakesNothingOfTheAnswer) {
  for (const test::DrawnScene& scene : scenes()) {
    Frame frame = test::drawn(scene);
    const OpenSpace seen = seen_in(frame);
    for (int v = 0; v < frame.height; ++v)
      for (int u = 0; u < frame.width; ++u)
        if (std::min({u, v, frame.width - 1 - u, frame.height - 1 - v}) < 16) *frame.pixel(u, v) = 0;
    const OpenSpace bordered = seen_in(frame);
    ASSERT_EQ(bordered.status, Status::kFound) << "seed " << scene.seed;
    EXPECT_NEAR(bordered.centroid_px.u_px, seen.centroid_px.u_px, kRounding_px) << "seed " << scene.seed;
    EXPECT_NEAR(bordered.centroid_px.v_px, seen.centroid_px.v_px, kRounding_px) << "seed " << scene.seed;
  }
}

TEST(AditProperties, AFrameIsJudgedAlone) {
  OpenSpaceFinder finder;
  for (const test::DrawnScene& scene : scenes()) {
    const Frame frame = test::drawn(scene);
    const OpenSpace fresh = seen_in(frame), after_others = finder.find(frame.view());
    EXPECT_EQ(after_others.status, fresh.status);
    EXPECT_EQ(after_others.centroid_px.u_px, fresh.centroid_px.u_px);
    EXPECT_EQ(after_others.confidence, fresh.confidence);
  }
}

}  // namespace
}  // namespace adit
