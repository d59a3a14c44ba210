// The method `adit` on drawn frames: each status, each rule, and what must not fool it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adit/finder.hpp"
#include "drawn_passage.hpp"

namespace adit {
namespace {

using test::drawn;
using test::DrawnScene;
using test::Frame;

OpenSpaceFinder finder(Clustering clustering = Clustering::kExact) {
  FinderConfig config;
  config.method = Method::kAdit;
  config.clustering = clustering;
  return OpenSpaceFinder(config);
}

OpenSpace seen_in(const Frame& frame) { return finder().find(frame.view()); }

void expect_at(const OpenSpace& seen, double u_px, double v_px, double tolerance_px) {
  ASSERT_EQ(seen.status, Status::kFound) << to_string(seen.status);
  EXPECT_NEAR(seen.centroid_px.u_px, u_px, tolerance_px);
  EXPECT_NEAR(seen.centroid_px.v_px, v_px, tolerance_px);
}

TEST(AditMethod, PointsAtThePlaceThatRockEncloses) {
  const OpenSpace seen = seen_in(drawn({.openings = {{420, 250, 70, 60}}}));
  expect_at(seen, 420, 250, 8);
  EXPECT_EQ(seen.rule, Rule::kEnclosed);
  EXPECT_EQ(seen.opening_count, 1);
  const Opening& best = seen.openings[0];
  EXPECT_EQ(best.bearing.azimuth_rad, seen.bearing.azimuth_rad);
  EXPECT_GT(best.contrast, 0.8);
  EXPECT_GT(best.score, 0.0);
  EXPECT_GT(seen.confidence, 0.5);
  EXPECT_FALSE(best.touches_border);
  EXPECT_NEAR(best.top_left_px.u_px, 350, 30);
  EXPECT_NEAR(best.bottom_right_px.u_px, 490, 30);
  EXPECT_NEAR(best.top_left_px.v_px, 190, 30);
  EXPECT_NEAR(best.bottom_right_px.v_px, 310, 30);
  EXPECT_GT(best.half_width_rad, 0.08);
  EXPECT_LT(best.half_width_rad, 0.25);
}

TEST(AditMethod, DarkCornersOfANarrowBeamAreNotOpen) {
  const OpenSpace seen = seen_in(drawn({.openings = {{380, 250, 60, 50}}, .beam_px = 190.0}));
  expect_at(seen, 380, 250, 20);
  EXPECT_EQ(seen.opening_count, 1);
}

TEST(AditMethod, EachBranchOfAJunctionIsAnOpening) {
  const OpenSpace seen = seen_in(drawn({.openings = {{160, 240, 60, 60}, {480, 250, 80, 60}}}));
  expect_at(seen, 480, 250, 12);  // the wider one
  ASSERT_EQ(seen.opening_count, 2);
  EXPECT_NEAR(seen.openings[1].centroid_px.u_px, 160, 12);
  EXPECT_LT(seen.openings[1].bearing.azimuth_rad, 0.0);
  EXPECT_GT(seen.openings[0].score, seen.openings[1].score);
}

TEST(AditMethod, AnOpeningCutByTheEdgeIsFoundAndSaidToBe) {
  const OpenSpace seen = seen_in(drawn({.openings = {{625, 250, 90, 70}}}));
  ASSERT_TRUE(seen.found()) << to_string(seen.status);
  EXPECT_EQ(seen.rule, Rule::kOpenSided);
  EXPECT_TRUE(seen.openings[0].touches_border);
  EXPECT_GT(seen.centroid_px.u_px, 560);
}

TEST(AditMethod, AWallHasNoOpening) {
  for (const double beam_px : {600.0, 300.0, 190.0}) {
    const OpenSpace seen = seen_in(drawn({.openings = {}, .beam_px = beam_px}));
    EXPECT_EQ(seen.status, Status::kNoOpening) << "beam " << beam_px;
    EXPECT_EQ(seen.rule, Rule::kNone);
    EXPECT_EQ(seen.confidence, 0.0);
    EXPECT_EQ(seen.opening_count, 0);
  }
}

/// As whole frames of a lens show it whose image circle just fits the sensor, with the arms of a vehicle below.
Frame with_glowing_rim(Frame frame, int rim_px) {
  for (int v = 0; v < frame.height; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const int inside_px = std::min({u, v, frame.width - 1 - u, frame.height - 1 - v});
      if (inside_px < rim_px) *frame.pixel(u, v) = 150;
    }
  }
  return frame;
}

TEST(AditMethod, TheRimOfTheLensEnclosesNothing) {
  for (const double beam_px : {400.0, 190.0}) {
    const Frame wall = drawn({.openings = {}, .beam_px = beam_px});
    EXPECT_EQ(seen_in(with_glowing_rim(wall, 12)).status, Status::kNoOpening) << "beam " << beam_px;
    const Frame passage = drawn({.openings = {{380, 250, 60, 50}}, .beam_px = beam_px});
    expect_at(seen_in(with_glowing_rim(passage, 12)), 380, 250, 20);
  }
}

TEST(AditMethod, ACableOnAWallIsNoOpening) {
  Frame frame = drawn({});
  test::add_cable(frame, 230, 12);
  EXPECT_EQ(seen_in(frame).status, Status::kNoOpening);
}

TEST(AditMethod, ALampInThePassageDoesNotHideIt) {
  Frame frame = drawn({.openings = {{300, 240, 90, 70}}});
  test::add_lamp(frame, 320, 230, 3);
  expect_at(seen_in(frame), 300, 240, 45);
}

TEST(AditMethod, LampOutIsTooDark) {
  EXPECT_EQ(seen_in(drawn({.openings = {}, .brightness = 0.0, .noise = 2})).status, Status::kTooDark);
}

TEST(AditMethod, DaylightIsTooBright) {
  EXPECT_EQ(seen_in(Frame(640, 480, PixelFormat::kGrey8, 235)).status, Status::kTooBright);
}

// Exposure that has not yet come down to a near wall: what is at the end of the range is smooth, but it is no dust.
TEST(AditMethod, AnOverexposedWallIsNoWayThroughDust) {
  for (const double brightness : {400.0, 700.0, 1000.0}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const OpenSpace seen =
          seen_in(drawn({.openings = {}, .beam_px = 300.0, .brightness = brightness, .texture = 0.4, .seed = seed}));
      EXPECT_FALSE(seen.found()) << "brightness " << brightness << " seed " << seed << " confidence "
                                 << seen.confidence;
    }
  }
}

TEST(AditMethod, OneGreyValueHasNoContrast) {
  EXPECT_EQ(seen_in(Frame(640, 480, PixelFormat::kGrey8, 90)).status, Status::kNoContrast);
}

TEST(AditMethod, DustIsFlaggedAndMeasured) {
  const OpenSpace clear = seen_in(drawn({.openings = {{380, 250, 80, 60}}}));
  EXPECT_FALSE(clear.flags.dust) << clear.veil_fraction;
  // Rock that is still seen on both sides, air alone between.
  const OpenSpace dusty =
      seen_in(drawn({.openings = {{360, 240, 240, 400}}, .beam_px = 400.0, .brightness = 40.0, .veil = 70.0}));
  EXPECT_TRUE(dusty.flags.dust) << dusty.veil_fraction;
  EXPECT_GT(dusty.veil_fraction, clear.veil_fraction);
  ASSERT_TRUE(dusty.found()) << to_string(dusty.status);
  EXPECT_EQ(dusty.rule, Rule::kVeil);
  EXPECT_NEAR(dusty.centroid_px.u_px, 360, 60);
  EXPECT_LT(dusty.confidence, 0.9);
}

TEST(AditMethod, WhereTheVeilIsAllThatIsSeenItSaysDust) {
  const OpenSpace seen =
      seen_in(drawn({.openings = {}, .beam_px = 300.0, .brightness = 0.0, .veil = 110.0, .noise = 2}));
  EXPECT_EQ(seen.status, Status::kDust) << to_string(seen.status);
  EXPECT_TRUE(seen.flags.dust);
  EXPECT_FALSE(seen.flags.blocked_lens);
  EXPECT_EQ(seen.opening_count, 0);
}

// Noise alone, however strong, is no rock: flat veils and lobes, quiet and at full gain.
TEST(AditMethod, ANoisyVeilWithoutRockIsNeverAWayOn) {
  for (const double beam_px : {300.0, 4000.0}) {
    for (const int noise : {4, 8, 12, 20, 35}) {
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const OpenSpace seen = seen_in(
            drawn({.openings = {}, .beam_px = beam_px, .brightness = 0.0, .veil = 90.0, .noise = noise, .seed = seed}));
        EXPECT_FALSE(seen.found()) << "beam " << beam_px << " noise " << noise << " confidence " << seen.confidence;
      }
    }
  }
}

// A little rock through much veil: whatever is said is said with doubt.
TEST(AditMethod, WhereDustHidesNearlyAllConfidenceIsLow) {
  const auto confidence = [](double brightness) {
    const OpenSpace seen =
        seen_in(drawn({.openings = {{360, 240, 240, 400}}, .beam_px = 400.0, .brightness = brightness, .veil = 100.0}));
    return seen.confidence;
  };
  EXPECT_LT(confidence(5.0), 0.55);
  EXPECT_LT(confidence(5.0), confidence(60.0));
}

TEST(AditMethod, ABrightBlurFromTheSideIsABlockedLens) {
  Frame frame(640, 480, PixelFormat::kGrey8);
  std::mt19937 random(5);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      *frame.pixel(u, v) = static_cast<std::uint8_t>(60.0 * std::exp2(u / 500.0) + test::between(random, -2, 2));
    }
  }
  const OpenSpace seen = seen_in(frame);
  EXPECT_EQ(seen.status, Status::kBlockedLens) << to_string(seen.status);
  EXPECT_TRUE(seen.flags.blocked_lens);
}

TEST(AditMethod, AForeignLampIsGlareAndALitWallIsNot) {
  Frame frame = drawn({.openings = {{300, 240, 90, 70}}});
  EXPECT_FALSE(seen_in(frame).flags.glare);
  test::add_lamp(frame, 320, 230, 5);
  EXPECT_TRUE(seen_in(frame).flags.glare);
}

TEST(AditMethod, AFrameNearTheEndsOfTheRangeIsFlagged) {
  EXPECT_TRUE(seen_in(drawn({.openings = {{300, 240, 90, 70}}, .brightness = 15.0, .noise = 1})).flags.too_dark);
  EXPECT_TRUE(seen_in(drawn({.openings = {{300, 240, 90, 70}}, .brightness = 330.0})).flags.too_bright);
}

TEST(AditMethod, AnswersMirrorWithTheFrame) {
  const Frame frame = drawn({.openings = {{200, 250, 70, 60}}});
  const OpenSpace seen = seen_in(frame);
  const OpenSpace mirrored = seen_in(test::mirrored(frame));
  ASSERT_TRUE(seen.found() && mirrored.found());
  EXPECT_NEAR(mirrored.centroid_px.u_px, 639.0 - seen.centroid_px.u_px, 1e-6);
  EXPECT_NEAR(mirrored.centroid_px.v_px, seen.centroid_px.v_px, 1e-6);
}

TEST(AditMethod, AnswersAreThoseOfEveryLayoutOfMemory) {
  const Frame grey = drawn({.openings = {{420, 250, 70, 60}}});
  const OpenSpace seen = seen_in(grey);
  for (const auto format :
       {PixelFormat::kBgr8, PixelFormat::kRgb8, PixelFormat::kBgra8, PixelFormat::kRgba8, PixelFormat::kGrey16}) {
    const OpenSpace other = seen_in(in_format(grey, format));
    EXPECT_EQ(other.centroid_px.u_px, seen.centroid_px.u_px);
    EXPECT_EQ(other.openings[0].score, seen.openings[0].score);
  }
}

TEST(AditMethod, FramesOfAllSizesGetAnAnswerThatIsANumber) {
  for (const auto& [width, height] : {std::pair{16, 16},
                                      {16, 400},
                                      {400, 16},
                                      {33, 17},
                                      {161, 120},
                                      {1279, 721},
                                      {8192, 16},
                                      {16, 8192},
                                      {1920, 1080}}) {
    const Frame frame = drawn({.width = width,
                               .height = height,
                               .openings = {{0.6 * width, 0.5 * height, 0.12 * width, 0.15 * height}},
                               .beam_px = 1.0 * width});
    const OpenSpace seen = seen_in(frame);
    EXPECT_NE(seen.status, Status::kBadFrame);
    EXPECT_TRUE(std::isfinite(seen.centroid_px.u_px) && std::isfinite(seen.bearing.azimuth_rad));
    EXPECT_TRUE(seen.confidence >= 0.0 && seen.confidence <= 1.0);
    if (width >= 161 && height >= 120) {
      ASSERT_TRUE(seen.found()) << width << " x " << height << " " << to_string(seen.status);
      EXPECT_NEAR(seen.centroid_px.u_px / width, 0.6, 0.03);
    }
  }
}

TEST(AditMethod, ExplainAnswersAsFindAndDrawsItsStages) {
  const Frame frame = drawn({.openings = {{420, 250, 70, 60}}});
  StageImages images;
  const OpenSpace seen = finder().explain(frame.view(), images);
  EXPECT_EQ(seen.centroid_px.u_px, seen_in(frame).centroid_px.u_px);
  const std::size_t pixels = 640 * 480;
  ASSERT_EQ(images.light.size(), pixels);
  ASSERT_EQ(images.enclosure.size(), pixels);
  ASSERT_EQ(images.openings.size(), pixels);
  EXPECT_EQ(images.openings[250 * 640 + 420], 1);
  EXPECT_EQ(images.openings[20 * 640 + 20], 0);
  EXPECT_GT(images.enclosure[250 * 640 + 420], 1.0f);
  EXPECT_LT(images.light[250 * 640 + 420], images.light[100 * 640 + 320]);
}

}  // namespace
}  // namespace adit
