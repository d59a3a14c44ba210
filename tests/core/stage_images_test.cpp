#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

TEST(StageImages, TellTheSameStoryAsTheAnswer) {
  const test::Frame frame = test::coloured_tunnel({.width = 131, .height = 97});
  OpenSpaceFinder finder(paper_preset());
  StageImages images;
  const OpenSpace seen = finder.explain(frame.view(), images);
  const OpenSpace alone = finder.find(frame.view());
  EXPECT_EQ(seen.moments.m10, alone.moments.m10);
  EXPECT_EQ(images.width, 131);
  EXPECT_EQ(images.height, 97);
  const std::size_t pixels = 131u * 97u;
  for (const std::size_t size :
       {images.dark_channel.size(), images.transmission.size(), images.scattering_depth.size(), images.closing.size(),
        images.closing_level.size(), images.cluster.size(), images.binary.size()}) {
    ASSERT_EQ(size, pixels);
  }
  std::uint64_t m00 = 0;
  std::uint64_t m10 = 0;
  std::array<std::uint64_t, kClusterCountMax> weight{};
  for (std::size_t i = 0; i < pixels; ++i) {
    EXPECT_EQ(images.binary[i] == 255, images.cluster[i] == 0);
    EXPECT_EQ(images.binary[i] == 255, images.closing_level[i] <= seen.threshold_level);
    EXPECT_GE(images.closing_level[i], images.dark_channel[i]) << "a closing never darkens";
    EXPECT_NEAR(images.scattering_depth[i], -std::log(images.transmission[i]), 1e-5);
    if (images.binary[i] == 255) {
      ++m00;
      m10 += i % 131;
    }
    ++weight[images.cluster[i]];
  }
  EXPECT_EQ(m00, seen.moments.m00);
  EXPECT_EQ(m10, seen.moments.m10);
  for (std::size_t c = 0; c < static_cast<std::size_t>(seen.clusters.count); ++c) {
    EXPECT_EQ(weight[c], seen.clusters.weight[c]);
  }
}

TEST(StageImages, RefusedFramesHavePicturesWhereThereArePixels) {
  OpenSpaceFinder finder(paper_preset());
  StageImages images;
  EXPECT_EQ(finder.explain(test::Frame(40, 30, PixelFormat::kBgr8, 0).view(), images).status, Status::kTooDark);
  EXPECT_EQ(images.transmission.size(), 1200u);
  EXPECT_EQ(*std::min_element(images.transmission.begin(), images.transmission.end()), 1.0f);
  EXPECT_EQ(finder.explain({}, images).status, Status::kBadFrame);
  EXPECT_EQ(images.width, 0);
  EXPECT_TRUE(images.binary.empty());
}

}  // namespace
}  // namespace adit
