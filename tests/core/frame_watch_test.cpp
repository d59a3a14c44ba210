#include "adit/frame_watch.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "lit_plan.hpp"

namespace adit {
namespace {

using test::Frame;

/// Frames of a flight down a passage, each with noise of its own.
Frame frame_of(int i, int width = 160, int height = 120) {
  static const test::LitPlan plan = [] {
    test::LitPlan p;
    p.add_passage({{-10, 0}, {60, 0}}, 5.0, true, false);
    return p;
  }();
  return plan.seen_from({0.05 * i, 0.3, 0.002 * i}, 1 + static_cast<unsigned>(i), width, height);
}

TEST(FrameWatch, HasNothingToSayOfAFlight) {
  FrameWatch watch;
  for (int i = 0; i < 40; ++i) EXPECT_EQ(watch.judge(frame_of(i).view()), Status::kFound) << i;
}

TEST(FrameWatch, NamesAFrozenStreamAtItsThirdFrame) {
  for (const PixelFormat format : {PixelFormat::kGrey8, PixelFormat::kBgr8, PixelFormat::kGrey16}) {
    FrameWatch watch;
    for (int i = 0; i < 5; ++i) (void)watch.judge(test::in_format(frame_of(i), format).view());
    const Frame hung = test::in_format(frame_of(5), format);
    EXPECT_EQ(watch.judge(hung.view()), Status::kFound);
    EXPECT_EQ(watch.judge(hung.view()), Status::kFound);  // a driver's hiccup
    EXPECT_EQ(watch.judge(hung.view()), Status::kFrozenFrame);
    EXPECT_EQ(watch.judge(hung.view()), Status::kFrozenFrame);
    EXPECT_EQ(watch.judge(test::in_format(frame_of(6), format).view()), Status::kFound);
  }
}

TEST(FrameWatch, ARepeatedFrameNowAndThenIsNoFault) {
  FrameWatch watch;
  for (int i = 0; i < 30; ++i) {
    const Frame frame = frame_of(i);
    EXPECT_EQ(watch.judge(frame.view()), Status::kFound);
    if (i % 5 != 0) continue;
    EXPECT_EQ(watch.judge(frame.view()), Status::kFound);
  }
}

TEST(FrameWatch, NamesFramesWhoseRowsAreThoseOfTheFrameBefore) {
  for (const double share : {0.3, 0.6, 0.85}) {
    for (const bool old_above : {false, true}) {
      FrameWatch watch;
      for (int i = 0; i < 5; ++i) (void)watch.judge(frame_of(i).view());
      Frame torn = frame_of(5);
      const Frame before = frame_of(4);
      const int seam = static_cast<int>(share * torn.height);
      const std::size_t at = static_cast<std::size_t>(seam) * static_cast<std::size_t>(torn.width);
      if (old_above)
        std::memcpy(torn.bytes.data(), before.bytes.data(), at);
      else
        std::memcpy(torn.bytes.data() + at, before.bytes.data() + at, torn.bytes.size() - at);
      EXPECT_EQ(watch.judge(torn.view()), Status::kTornFrame) << share << old_above;
      EXPECT_EQ(watch.judge(frame_of(6).view()), Status::kFound);
    }
  }
}

TEST(FrameWatch, NamesRowsThatLostTheirSignalWithinThreeFrames) {
  FrameWatch watch;
  for (int i = 0; i < 5; ++i) (void)watch.judge(frame_of(i).view());
  bool named = false;
  for (int i = 5; i < 8; ++i) {
    Frame cut = frame_of(i);
    std::fill(cut.bytes.begin() + static_cast<std::ptrdiff_t>(cut.bytes.size() * 2 / 3), cut.bytes.end(), 128);
    named = named || watch.judge(cut.view()) == Status::kTornFrame;
  }
  EXPECT_TRUE(named);
}

TEST(FrameWatch, NamesAJumpFromEdgeToEdge) {
  FrameWatch watch;
  for (int i = 0; i < 5; ++i) (void)watch.judge(frame_of(i).view());
  // The lower half is of a frame that nobody has seen: brighter and elsewhere.
  Frame torn = frame_of(5);
  const std::size_t half = torn.bytes.size() / 2;
  for (std::size_t i = half; i < torn.bytes.size(); ++i)
    torn.bytes[i] = static_cast<std::uint8_t>(std::min(255, torn.bytes[i - half / 2] + 40));
  EXPECT_EQ(watch.judge(torn.view()), Status::kTornFrame);
}

TEST(FrameWatch, AMaskAtTheEdgeIsThePicture) {
  FrameWatch watch;
  int named = 0;
  for (int i = 0; i < 60; ++i) {
    Frame masked = frame_of(i, 80, 60);
    std::fill(masked.bytes.begin(), masked.bytes.begin() + 80 * 12, 0);  // black bars, always there
    std::fill(masked.bytes.end() - 80 * 12, masked.bytes.end(), 0);
    named += watch.judge(masked.view()) == Status::kFound ? 0 : 1;
  }
  EXPECT_EQ(named, 0);
}

TEST(FrameWatch, AnythingMayCome) {
  FrameWatch watch;
  EXPECT_EQ(watch.judge(ImageView{}), Status::kFound);
  (void)watch.judge(test::noise(16, 16, PixelFormat::kRgba8, 1).view());
  (void)watch.judge(test::noise(31, 17, PixelFormat::kGrey16, 2).view());
  (void)watch.judge(test::noise(17, 400, PixelFormat::kBgr8, 3).view());
}

}  // namespace
}  // namespace adit
