// Pixels that do not lie side by side are judged as their packed copy is, to the bit, and nothing is allocated for
// them.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "adit/navigator.hpp"
#include "frames.hpp"
#include "spread_frame.hpp"

namespace adit {
namespace {

using test::Frame;
using test::SpreadFrame;

/// All that a judgement says, but for the time it took.
void expect_same(OpenSpace a, OpenSpace b, const std::string& what) {
  a.stage_ns = b.stage_ns = {};
  a.total_ns = b.total_ns = 0;
  EXPECT_EQ(a.status, b.status) << what;
  EXPECT_EQ(a.atmospheric_light, b.atmospheric_light) << what;
  EXPECT_EQ(a.threshold_level, b.threshold_level) << what;
  EXPECT_EQ(a.darkest_level, b.darkest_level) << what;
  EXPECT_EQ(a.brightest_level, b.brightest_level) << what;
  EXPECT_EQ(a.moments.m00, b.moments.m00) << what;
  EXPECT_EQ(a.moments.m10, b.moments.m10) << what;
  EXPECT_EQ(a.moments.m20, b.moments.m20) << what;
  EXPECT_EQ(a.centroid_px.u_px, b.centroid_px.u_px) << what;
  EXPECT_EQ(a.centroid_px.v_px, b.centroid_px.v_px) << what;
  EXPECT_EQ(a.confidence, b.confidence) << what;
  EXPECT_EQ(a.veil_fraction, b.veil_fraction) << what;
  EXPECT_EQ(a.opening_count, b.opening_count) << what;
  for (std::size_t i = 0; i < a.openings.size(); ++i) EXPECT_EQ(a.openings[i].score, b.openings[i].score) << what;
}

/// A frame of each format that has something to see, wider than the pieces that rows are gathered in.
std::vector<Frame> frames_of_all_formats() {
  std::vector<Frame> frames;
  for (const auto& [width, height] : {std::pair{160, 120}, {77, 61}, {517, 48}}) {
    const test::Tunnel tunnel{.width = width, .height = height, .u_px = 0.4 * width, .v_px = 0.5 * height};
    const Frame bgr = test::coloured_tunnel(tunnel), grey = test::tunnel(tunnel);
    frames.push_back(grey);
    frames.push_back(test::in_format(grey, PixelFormat::kGrey16));
    frames.push_back(bgr);
    for (const auto format : {PixelFormat::kRgb8, PixelFormat::kBgra8, PixelFormat::kRgba8})
      frames.push_back(test::reordered(bgr, format));
  }
  return frames;
}

TEST(FinderLayouts, EveryLayoutIsJudgedAsItsPackedCopy) {
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    FinderConfig config = paper_preset();
    config.method = method;
    OpenSpaceFinder finder(config);
    for (const Frame& frame : frames_of_all_formats()) {
      const OpenSpace seen = finder.find(frame.view());
      int spread = 0;
      for (const SpreadFrame& other : test::spreads_of(frame)) {
        EXPECT_EQ(fault_of(other.view), "") << other.name;
        spread += other.view.is_packed() ? 0 : 1;
        expect_same(finder.find(other.view), seen, other.name);
      }
      EXPECT_GE(spread, 5);
    }
  }
}

/// As numpy broadcasts: one grey value for all channels, one row for all rows, one column for all columns.
TEST(FinderLayouts, StridesOfZero) {
  const Frame grey = test::tunnel({}), bgr = test::in_format(grey, PixelFormat::kBgr8);
  OpenSpaceFinder finder(paper_preset());
  const ImageView channels{grey.bytes.data(), 160, 120, 160, PixelFormat::kBgr8, 1, 0};
  expect_same(finder.find(channels), finder.find(bgr.view()), "channels");
  Frame lines(160, 120, PixelFormat::kGrey8), columns = lines;
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) {
      *lines.pixel(u, v) = *grey.pixel(u, 0);
      *columns.pixel(u, v) = *grey.pixel(0, v);
    }
  expect_same(finder.find({grey.bytes.data(), 160, 120, 0, PixelFormat::kGrey8, 1}), finder.find(lines.view()), "rows");
  expect_same(finder.find({grey.bytes.data(), 160, 120, 160, PixelFormat::kGrey8, 0}), finder.find(columns.view()),
              "columns");
}

TEST(FinderLayouts, WithPatchesOfEverySize) {
  FinderConfig config = paper_preset();
  for (const int size_px : {1, 3, 31}) {
    config.patch_size_px = size_px;
    OpenSpaceFinder finder(config);
    const Frame frame = test::coloured_tunnel({});
    const OpenSpace seen = finder.find(frame.view());
    for (const SpreadFrame& other : test::spreads_of(frame)) expect_same(finder.find(other.view), seen, other.name);
  }
}

TEST(FinderLayouts, StagesAndPairsToo) {
  FinderConfig config;
  config.method = Method::kAdit;
  OpenSpaceFinder finder(config);
  const Frame lit = test::coloured_tunnel({.noise = 3}), dark = test::coloured_tunnel({.brightest = 60, .seed = 4});
  StageImages images, others;
  const OpenSpace seen = finder.explain(lit.view(), images), pair = finder.find_flash(lit.view(), dark.view());
  const auto darks = test::spreads_of(dark);
  std::size_t i = 0;
  for (const SpreadFrame& other : test::spreads_of(lit)) {
    expect_same(finder.explain(other.view, others), seen, other.name);
    EXPECT_EQ(others.dark_channel, images.dark_channel) << other.name;
    EXPECT_EQ(others.closing_level, images.closing_level) << other.name;
    expect_same(finder.find_flash(other.view, darks[i++].view), pair, other.name);
  }
}

/// Ranges from the light, the watch over frozen and torn frames, and the command: all as of packed frames.
TEST(FinderLayouts, TheNavigatorDoesTheSame) {
  const Frame grey = test::tunnel({.seed = 1}), other_grey = test::tunnel({.seed = 2});
  const std::array<Frame, 2> first{test::coloured_tunnel({.seed = 1}), test::in_format(grey, PixelFormat::kGrey16)};
  const std::array<Frame, 2> second{test::coloured_tunnel({.seed = 2}),
                                    test::in_format(other_grey, PixelFormat::kGrey16)};
  for (std::size_t kind = 0; kind < first.size(); ++kind) {
    const auto a = test::spreads_of(first[kind]), b = test::spreads_of(second[kind]);
    for (std::size_t i = 0; i < a.size(); ++i) {
      Navigator packed, spread;
      int frozen = 0;
      for (int frame = 0; frame < 16; ++frame) {
        const bool is_second = frame >= 3;  // and then the same picture for ever
        const double stamp_s = 0.05 * frame;
        const Sight want = packed.look((is_second ? second : first)[kind].view());
        const Sight seen = spread.look((is_second ? b : a)[i].view);
        expect_same(seen.open_space, want.open_space, a[i].name);
        EXPECT_EQ(seen.profile.light, want.profile.light) << a[i].name;
        EXPECT_EQ(seen.profile.range_m, want.profile.range_m) << a[i].name;
        EXPECT_EQ(spread.steer(seen, stamp_s).heading.yaw_rate_rad_s,
                  packed.steer(want, stamp_s).heading.yaw_rate_rad_s);
        frozen += seen.open_space.status == Status::kFrozenFrame ? 1 : 0;
      }
      EXPECT_GT(frozen, 0) << a[i].name;
    }
  }
}

TEST(FinderLayouts, TheWatchSeesWhatIsTornInAnyLayout) {
  const Frame one = test::coloured_tunnel({.seed = 1});
  Frame torn = test::coloured_tunnel({.seed = 2}), dead = test::coloured_tunnel({.seed = 3});
  std::memcpy(torn.pixel(0, 0), one.pixel(0, 0), 3u * 160u * 70u);  // the upper part of the frame before
  std::memset(dead.pixel(0, 60), 0, 3u * 160u * 60u);               // the lower part never came
  const auto ones = test::spreads_of(one), torns = test::spreads_of(torn), deads = test::spreads_of(dead);
  for (std::size_t i = 0; i < ones.size(); ++i)
    for (const SpreadFrame& next : {torns[i], deads[i]}) {
      FrameWatch watch;
      EXPECT_EQ(watch.judge(ones[i].view), Status::kFound);
      EXPECT_EQ(watch.judge(next.view), Status::kTornFrame) << next.name;
    }
}

}  // namespace
}  // namespace adit
