// The dark channel against the plain version: every format, every width from 16 to 80, strides of all kinds.
#include "adit/dark_channel.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::TargetInUse;
using reference::Content;
using reference::Frame;
using reference::Layout;
using reference::Plane;

void judge(const ImageView& view, int patch_size_px, int depth_bits, MorphologyScratch& scratch) {
  const StructuringElement patch = StructuringElement::rectangle(patch_size_px, patch_size_px);
  const Plane want = reference::dark_channel(view, patch_size_px, depth_bits);
  scratch.reserve(view.width, view.height, patch);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    Plane out(view.width, view.height, 99);
    dark_channel(view, patch, depth_bits, out.view(), scratch);
    ASSERT_TRUE(judging::same_levels(out.view(), want.view()))
        << view.width << " x " << view.height << " px, stride " << view.stride_bytes << " bytes, patch "
        << patch_size_px << ", " << depth_bits << " bits, " << target;
  }
}

class DarkChannelOfFormat : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(DarkChannelOfFormat, AgreesWithThePlainVersion) {
  MorphologyScratch scratch;
  constexpr Layout kLayouts[] = {{0, false}, {6, false}, {0, true}, {130, true}};
  constexpr int kPatches[] = {1, 3, 7, 15, 33};
  for (int width = 16; width <= 80; width += judging::grid_is_small() ? 9 : 1) {
    const auto seed = static_cast<std::uint64_t>(width);
    const int height = 16 + width * 5 % 13;
    for (std::size_t i = 0; i < std::size(kLayouts); ++i) {
      const Content content = reference::kContents[reference::hash_of(seed, i) % 6];
      const int patch = kPatches[reference::hash_of(seed, i, 1) % std::size(kPatches)];
      const int depth_bits = 8 + static_cast<int>(reference::hash_of(seed, i, 2) % 9);
      const Frame frame(content, GetParam(), width, height, seed, kLayouts[i]);
      ASSERT_NO_FATAL_FAILURE(judge(frame.view(), patch, depth_bits, scratch));
    }
  }
}

// A frame that a patch of 15 does not cover, and the smallest one, which it nearly does.
TEST_P(DarkChannelOfFormat, AgreesWithThePlainVersionOnLargerFrames) {
  MorphologyScratch scratch;
  for (const Content content : {Content::kImpulses, Content::kTunnel}) {
    const int width = judging::grid_is_small() ? 131 : 323;
    ASSERT_NO_FATAL_FAILURE(judge(Frame(content, GetParam(), width, 97, 5).view(), 15, 12, scratch));
    ASSERT_NO_FATAL_FAILURE(judge(Frame(content, GetParam(), 16, 16, 6).view(), 15, 16, scratch));
    ASSERT_NO_FATAL_FAILURE(judge(Frame(content, GetParam(), 16, 300, 7, {3 * 16, true}).view(), 5, 10, scratch));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, DarkChannelOfFormat, ::testing::ValuesIn(reference::kFormats),
                         [](const auto& format) { return std::string(reference::to_string(format.param)); });

// Alpha 0 in every pixel would be the smallest value, were it looked at.
TEST(DarkChannel, AlphaTakesNoPart) {
  MorphologyScratch scratch;
  for (const PixelFormat format : {PixelFormat::kBgra8, PixelFormat::kRgba8}) {
    Frame frame(Content::kFlat, format, 50, 20, 1);
    for (std::size_t i = 0; i < frame.bytes().size(); ++i) {
      frame.bytes()[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 0 : 90 + i % 4);
    }
    const StructuringElement patch = StructuringElement::rectangle(3, 3);
    scratch.reserve(50, 20, patch);
    for (const std::string_view target : supported_cpu_targets()) {
      const TargetInUse in_use(target);
      Plane out(50, 20);
      dark_channel(frame.view(), patch, 16, out.view(), scratch);
      EXPECT_EQ(out, Plane(50, 20, 90)) << target;
    }
  }
}

// Values above what the depth allows count as the brightest, not as their low bits.
TEST(DarkChannel, SixteenBitsAreClampedAtEveryDepth) {
  MorphologyScratch scratch;
  for (int depth_bits = 8; depth_bits <= 16; ++depth_bits) {
    const Frame frame(Content::kNoise, PixelFormat::kGrey16, 256, 64, 9);
    ASSERT_NO_FATAL_FAILURE(judge(frame.view(), 1, depth_bits, scratch));
  }
}

}  // namespace
}  // namespace adit
