// What must hold between the answers to two frames that are related.
#include <gtest/gtest.h>

#include <cmath>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::Frame;

OpenSpace seen_in(const Frame& frame, const FinderConfig& config = paper_preset()) {
  return OpenSpaceFinder(config).find(frame.view());
}

FinderConfig with_sizes(int patch_px, int element_px) {
  FinderConfig config = paper_preset();
  config.patch_size_px = patch_px;
  config.structuring_element_size_px = element_px;
  return config;
}

std::vector<Frame> some_frames() {
  std::vector<Frame> frames;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const int width = 97 + 37 * static_cast<int>(seed);
    const int height = 71 + 22 * static_cast<int>(seed);
    frames.push_back(test::coloured_tunnel({.width = width,
                                            .height = height,
                                            .u_px = 0.1 * seed * width,
                                            .v_px = 0.6 * height,
                                            .noise = 20,
                                            .seed = seed}));
    frames.push_back(test::tunnel({.width = height, .height = width, .u_px = 0.4 * height, .seed = seed}));
  }
  return frames;
}

TEST(FinderProperties, MirrorTheFrameAndTheCentroidMirrors) {
  for (const Frame& frame : some_frames()) {
    const OpenSpace seen = seen_in(frame);
    const OpenSpace mirrored = seen_in(test::mirrored(frame));
    ASSERT_EQ(seen.status, Status::kFound);
    EXPECT_EQ(mirrored.status, seen.status);
    EXPECT_EQ(mirrored.atmospheric_light, seen.atmospheric_light);
    EXPECT_EQ(mirrored.threshold_level, seen.threshold_level);
    EXPECT_EQ(mirrored.moments.m00, seen.moments.m00);
    EXPECT_NEAR(mirrored.centroid_px.u_px, frame.width - 1 - seen.centroid_px.u_px, 1e-9);
    EXPECT_NEAR(mirrored.centroid_px.v_px, seen.centroid_px.v_px, 1e-9);
    EXPECT_NEAR(mirrored.point.sx, -seen.point.sx, 1e-12);
    EXPECT_NEAR(mirrored.bearing.azimuth_rad, -seen.bearing.azimuth_rad, 1e-12);
    EXPECT_NEAR(mirrored.confidence, seen.confidence, 1e-9);
  }
}

TEST(FinderProperties, FlipTheFrameAndTheCentroidFlips) {
  for (const Frame& frame : some_frames()) {
    const OpenSpace seen = seen_in(frame);
    const OpenSpace flipped = seen_in(test::flipped(frame));
    EXPECT_EQ(flipped.moments.m00, seen.moments.m00);
    EXPECT_NEAR(flipped.centroid_px.u_px, seen.centroid_px.u_px, 1e-9);
    EXPECT_NEAR(flipped.centroid_px.v_px, frame.height - 1 - seen.centroid_px.v_px, 1e-9);
    EXPECT_NEAR(flipped.bearing.elevation_rad, -seen.bearing.elevation_rad, 1e-12);
  }
}

TEST(FinderProperties, TransposeTheFrameAndTheCentroidIsTransposed) {
  for (const Frame& frame : some_frames()) {
    // Exact with an element that is its own transpose, and close with the ellipse, which as OpenCV draws it is not.
    for (const auto& [element_px, tolerance_px] : {std::pair{1, 1e-9}, std::pair{9, 1.0}}) {
      const FinderConfig config = with_sizes(7, element_px);
      const OpenSpace seen = seen_in(frame, config);
      const OpenSpace transposed = seen_in(test::transposed(frame), config);
      EXPECT_EQ(transposed.status, seen.status);
      EXPECT_NEAR(transposed.centroid_px.u_px, seen.centroid_px.v_px, tolerance_px);
      EXPECT_NEAR(transposed.centroid_px.v_px, seen.centroid_px.u_px, tolerance_px);
    }
  }
}

Frame brightened(Frame frame, double by) {
  for (auto& byte : frame.bytes) byte = static_cast<std::uint8_t>(std::lround(byte * by));
  return frame;
}

TEST(FinderProperties, BrightnessByAWholeFactorChangesNothing) {
  for (const int factor : {2, 3, 4}) {
    const Frame frame = test::coloured_tunnel({.brightest = 50, .noise = 8});
    const OpenSpace seen = seen_in(frame);
    const OpenSpace brighter = seen_in(brightened(frame, factor));
    ASSERT_EQ(seen.status, Status::kFound);
    EXPECT_EQ(brighter.status, Status::kFound);
    EXPECT_NEAR(brighter.atmospheric_light, factor * seen.atmospheric_light, 1e-9);
    EXPECT_EQ(brighter.threshold_level, factor * seen.threshold_level);
    EXPECT_EQ(brighter.moments.m00, seen.moments.m00);
    EXPECT_NEAR(brighter.centroid_px.u_px, seen.centroid_px.u_px, 1e-9);
    EXPECT_NEAR(brighter.centroid_px.v_px, seen.centroid_px.v_px, 1e-9);
  }
}

TEST(FinderProperties, BrightnessByAnyFactorMovesTheCentroidByTheRoundingOnly) {
  // 8-bit levels are rounded after scaling, so some pixels change sides at the threshold: a part of one level's
  // contour, here a few pixels wide. The centroid of the region moves by less than two.
  for (const double factor : {0.35, 0.6, 0.85, 1.13}) {
    const Frame frame = test::coloured_tunnel({.width = 320, .height = 240, .u_px = 120, .v_px = 100});
    const OpenSpace seen = seen_in(frame);
    const OpenSpace scaled = seen_in(brightened(frame, factor));
    ASSERT_EQ(scaled.status, Status::kFound);
    EXPECT_NEAR(scaled.centroid_px.u_px, seen.centroid_px.u_px, 2.0) << factor;
    EXPECT_NEAR(scaled.centroid_px.v_px, seen.centroid_px.v_px, 2.0) << factor;
  }
}

Frame bordered(const Frame& frame, int border_px, int level) {
  Frame out(frame.width + 2 * border_px, frame.height + 2 * border_px, frame.format, level);
  for (int v = 0; v < frame.height; ++v) {
    for (int u = 0; u < frame.width; ++u) *out.pixel(u + border_px, v + border_px) = *frame.pixel(u, v);
  }
  return out;
}

TEST(FinderProperties, ABorderOfTheBrightestLevelHardlyMovesTheCentroid) {
  // The border joins the brightest cluster; the others give way by a level or two, so the region's edge moves a little.
  const Frame frame = test::tunnel({.width = 240, .height = 180, .u_px = 100, .v_px = 80});
  const FinderConfig config = with_sizes(5, 5);
  const OpenSpace seen = seen_in(frame, config);
  for (const int border_px : {10, 25, 40}) {
    const OpenSpace framed = seen_in(bordered(frame, border_px, 226), config);
    ASSERT_EQ(framed.status, Status::kFound);
    EXPECT_NEAR(framed.centroid_px.u_px - border_px, seen.centroid_px.u_px, 3.0);
    EXPECT_NEAR(framed.centroid_px.v_px - border_px, seen.centroid_px.v_px, 3.0);
  }
}

TEST(FinderProperties, ABlackBorderPullsTheCentroidToTheMiddleAsPublished) {
  // The moments are those of all dark pixels: a lens's black rim counts. The confidence says so.
  const Frame frame = test::tunnel({.width = 240, .height = 180, .u_px = 60, .v_px = 60});
  const OpenSpace seen = seen_in(frame, with_sizes(5, 5));
  const OpenSpace framed = seen_in(bordered(frame, 40, 0), with_sizes(5, 5));
  const double middle_px = 0.5 * (frame.width - 1);
  EXPECT_LT(std::abs(framed.centroid_px.u_px - 40 - middle_px), 0.5 * std::abs(seen.centroid_px.u_px - middle_px));
  EXPECT_LT(framed.confidence, 0.7 * seen.confidence);
}

TEST(FinderProperties, BetaMovesNoCluster) {
  FinderConfig config = paper_preset();
  const Frame frame = test::coloured_tunnel({});
  const OpenSpace seen = seen_in(frame, config);
  for (const double beta : {0.001, 0.3, 1000.0}) {
    config.scattering_coefficient = beta;
    const OpenSpace other = seen_in(frame, config);
    EXPECT_EQ(other.threshold_level, seen.threshold_level);
    EXPECT_EQ(other.moments.m10, seen.moments.m10);
    EXPECT_NEAR(other.clusters.centre[1] * beta, seen.clusters.centre[1], 1e-9);
  }
}

TEST(FinderProperties, AFrameIsJudgedAlone) {
  OpenSpaceFinder finder(paper_preset());
  const Frame first = test::coloured_tunnel({});
  const Frame second = test::tunnel({.u_px = 110, .seed = 4});
  const OpenSpace alone = finder.find(first.view());
  (void)finder.find(second.view());
  (void)finder.find(test::tunnel({.width = 64, .height = 333}).view());
  const OpenSpace again = finder.find(first.view());
  EXPECT_EQ(alone.moments.m10, again.moments.m10);
  EXPECT_EQ(alone.confidence, again.confidence);
  EXPECT_EQ(alone.atmospheric_light, again.atmospheric_light);
}

TEST(FinderProperties, LloydIsRepeatableAndNear) {
  FinderConfig config = paper_preset();
  const Frame frame = test::coloured_tunnel({.width = 320, .height = 240, .u_px = 120, .v_px = 100});
  const OpenSpace exact = seen_in(frame, config);
  config.clustering = Clustering::kLloyd;
  config.lloyd_iterations_max = 200;
  config.lloyd_starts = 20;
  const OpenSpace lloyd = seen_in(frame, config);
  EXPECT_EQ(lloyd.moments.m10, seen_in(frame, config).moments.m10);
  EXPECT_GE(lloyd.clusters.cost, exact.clusters.cost * (1 - 1e-12));
  EXPECT_NEAR(lloyd.centroid_px.u_px, exact.centroid_px.u_px, 10.0);
}

TEST(FinderProperties, StagesAreTimed) {
  const OpenSpace seen = seen_in(test::coloured_tunnel({}));
  std::int64_t sum = 0;
  for (const auto ns : seen.stage_ns) {
    EXPECT_GE(ns, 0);
    sum += ns;
  }
  EXPECT_GT(sum, 0);
  EXPECT_GE(seen.total_ns, sum);
}

}  // namespace
}  // namespace adit
