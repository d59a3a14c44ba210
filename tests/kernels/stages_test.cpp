// What the finder says of its stages is what the plain versions find: also where stages are fused inside.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "adit/finder.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::TargetInUse;
using reference::Content;
using reference::Frame;
using reference::Layout;
using reference::Plane;

/// The stages of one frame, found plainly.
struct PlainStages {
  Plane dark;
  Plane closed;
  double atmospheric_light;

  PlainStages(const ImageView& view, const FinderConfig& config)
      : dark(reference::dark_channel(view, config.patch_size_px, config.grey16_depth_bits)),
        closed(reference::close(
            dark, StructuringElement::ellipse(config.structuring_element_size_px, config.structuring_element_size_px))),
        atmospheric_light(
            reference::atmospheric_light(view, config.grey16_depth_bits, dark, config.atmospheric_light_fraction)) {}
};

void judge(const OpenSpace& space, const PlainStages& plain) {
  EXPECT_EQ(space.atmospheric_light, plain.atmospheric_light);
  if (space.clusters.count == 0) return;
  const Histogram histogram = reference::histogram_of(plain.closed);
  EXPECT_GT(histogram[static_cast<std::size_t>(space.darkest_level)], 0U);
  EXPECT_GT(histogram[static_cast<std::size_t>(space.brightest_level)], 0U);
  std::uint64_t weight = 0;
  for (int i = 0; i < space.clusters.count; ++i) weight += space.clusters.weight[static_cast<std::size_t>(i)];
  EXPECT_EQ(weight, plain.closed.pixels.size());
  if (!space.found()) return;
  const Moments moments = reference::moments_of(plain.closed, space.threshold_level);
  EXPECT_EQ(space.moments.m00, moments.m00);
  EXPECT_EQ(space.moments.m10, moments.m10);
  EXPECT_EQ(space.moments.m01, moments.m01);
  EXPECT_EQ(space.moments.m20, moments.m20);
  EXPECT_EQ(space.moments.m02, moments.m02);
}

class StagesOfFormat : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(StagesOfFormat, AreThoseOfThePlainVersions) {
  FinderConfig config = paper_preset();
  config.patch_size_px = 5;
  config.structuring_element_size_px = 9;
  config.grey16_depth_bits = 14;
  OpenSpaceFinder finder(config);
  for (int width = 17; width <= 260; width += judging::grid_is_small() ? 81 : 27) {
    const auto seed = static_cast<std::uint64_t>(width);
    const Content content = reference::kContents[reference::hash_of(seed) % 6];
    const Frame frame(content, GetParam(), width, 16 + width / 3, seed, Layout{width % 2 * 4, width % 3 == 0});
    const PlainStages plain(frame.view(), config);
    for (const std::string_view target : supported_cpu_targets()) {
      const TargetInUse in_use(target);
      SCOPED_TRACE(::testing::Message() << width << " px wide, " << to_string(content) << ", " << target);
      judge(finder.find(frame.view()), plain);
      StageImages images;
      judge(finder.explain(frame.view(), images), plain);
      const ConstPlaneView dark(images.dark_channel.data(), images.width, images.height, images.width);
      EXPECT_TRUE(judging::same_levels(dark, plain.dark.view()));
      const ConstPlaneView closed(images.closing_level.data(), images.width, images.height, images.width);
      EXPECT_TRUE(judging::same_levels(closed, plain.closed.view()));
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, StagesOfFormat, ::testing::ValuesIn(reference::kFormats),
                         [](const auto& format) { return std::string(reference::to_string(format.param)); });

}  // namespace
}  // namespace adit
