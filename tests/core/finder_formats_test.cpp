// The same light in another layout of memory gives the same bits.
#include <gtest/gtest.h>

#include <cstring>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::Frame;

void expect_same(const OpenSpace& a, const OpenSpace& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.atmospheric_light, b.atmospheric_light);
  EXPECT_EQ(a.threshold_level, b.threshold_level);
  EXPECT_EQ(a.darkest_level, b.darkest_level);
  EXPECT_EQ(a.brightest_level, b.brightest_level);
  EXPECT_EQ(a.moments.m00, b.moments.m00);
  EXPECT_EQ(a.moments.m10, b.moments.m10);
  EXPECT_EQ(a.moments.m01, b.moments.m01);
  EXPECT_EQ(a.moments.m20, b.moments.m20);
  EXPECT_EQ(a.centroid_px.u_px, b.centroid_px.u_px);
  EXPECT_EQ(a.bearing.azimuth_rad, b.bearing.azimuth_rad);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.clusters.cost, b.clusters.cost);
}

constexpr PixelFormat kAll[] = {PixelFormat::kGrey8, PixelFormat::kBgr8,  PixelFormat::kRgb8,
                                PixelFormat::kBgra8, PixelFormat::kRgba8, PixelFormat::kGrey16};

TEST(FinderFormats, GreyInAnyFormatIsTheSame) {
  for (const auto& [width, height] : {std::pair{160, 120}, {77, 33}, {16, 16}, {129, 201}}) {
    const Frame grey = test::tunnel({.width = width, .height = height, .u_px = 0.4 * width, .v_px = 0.5 * height});
    OpenSpaceFinder finder(paper_preset());
    const OpenSpace seen = finder.find(grey.view());
    for (const auto format : kAll) expect_same(finder.find(test::in_format(grey, format).view()), seen);
  }
}

TEST(FinderFormats, ColourInAnyOrderIsTheSame) {
  const Frame bgr = test::coloured_tunnel({.width = 131, .height = 97});
  OpenSpaceFinder finder(paper_preset());
  const OpenSpace seen = finder.find(bgr.view());
  for (const auto format : {PixelFormat::kRgb8, PixelFormat::kBgra8, PixelFormat::kRgba8}) {
    expect_same(finder.find(test::reordered(bgr, format).view()), seen);
  }
}

TEST(FinderFormats, BitsOfSixteenBitFrames) {
  const Frame grey = test::tunnel({});
  const OpenSpace seen = OpenSpaceFinder(paper_preset()).find(grey.view());
  for (const int bits : {8, 10, 12, 14, 16}) {
    Frame deep(grey.width, grey.height, PixelFormat::kGrey16);
    for (int v = 0; v < grey.height; ++v) {
      for (int u = 0; u < grey.width; ++u) {
        const auto value = static_cast<std::uint16_t>(*grey.pixel(u, v) << (bits - 8));
        std::memcpy(deep.pixel(u, v), &value, sizeof value);
      }
    }
    FinderConfig config = paper_preset();
    config.grey16_depth_bits = bits;
    expect_same(OpenSpaceFinder(config).find(deep.view()), seen);
  }
}

TEST(FinderFormats, ValuesAboveTheBitsInUseAreWhite) {
  Frame deep(64, 48, PixelFormat::kGrey16, 0xFF);
  FinderConfig config = paper_preset();
  config.grey16_depth_bits = 10;
  const OpenSpace seen = OpenSpaceFinder(config).find(deep.view());
  EXPECT_EQ(seen.darkest_level, 255);
  EXPECT_EQ(seen.status, Status::kTooBright);
}

/// The frame with the stride and the origin that a foreign buffer may have; what lies between rows is noise.
TEST(FinderFormats, StrideAndOrientationOfTheMemory) {
  for (const auto format : kAll) {
    const Frame frame = test::in_format(test::tunnel({.width = 101, .height = 67}), format);
    OpenSpaceFinder finder(paper_preset());
    const OpenSpace seen = finder.find(frame.view());
    const std::ptrdiff_t row_bytes = frame.view().stride_bytes;
    for (const std::ptrdiff_t padding : {2, 6, 64, 1000}) {
      const std::ptrdiff_t stride = row_bytes + padding;
      std::vector<std::uint8_t> buffer =
          test::noise(static_cast<int>(stride), frame.height, PixelFormat::kGrey8, 3).bytes;
      for (int v = 0; v < frame.height; ++v) {
        std::memcpy(buffer.data() + v * stride, frame.view().row(v), static_cast<std::size_t>(row_bytes));
      }
      expect_same(finder.find({buffer.data(), frame.width, frame.height, stride, format}), seen);
      // Bottom up: the first row stands last in memory.
      for (int v = 0; v < frame.height; ++v) {
        std::memcpy(buffer.data() + (frame.height - 1 - v) * stride, frame.view().row(v),
                    static_cast<std::size_t>(row_bytes));
      }
      expect_same(
          finder.find({buffer.data() + (frame.height - 1) * stride, frame.width, frame.height, -stride, format}), seen);
    }
  }
}

TEST(FinderFormats, ARegionOfALargerImage) {
  const Frame large = test::coloured_tunnel({.width = 300, .height = 200, .u_px = 150, .v_px = 90});
  OpenSpaceFinder finder(paper_preset());
  for (const auto& [u, v, width, height] :
       {std::tuple{10, 20, 200, 150}, {101, 3, 97, 131}, {0, 0, 300, 200}, {299 - 64, 199 - 48, 64, 48}}) {
    Frame cut(width, height, PixelFormat::kBgr8);
    for (int y = 0; y < height; ++y)
      std::memcpy(cut.pixel(0, y), large.pixel(u, v + y), 3u * static_cast<unsigned>(width));
    const ImageView region{large.pixel(u, v), width, height, large.view().stride_bytes, PixelFormat::kBgr8};
    expect_same(finder.find(region), finder.find(cut.view()));
  }
}

TEST(FinderFormats, ThePixelsAreNotWritten) {
  const Frame frame = test::coloured_tunnel({});
  const Frame before = frame;
  (void)OpenSpaceFinder(paper_preset()).find(frame.view());
  EXPECT_EQ(frame.bytes, before.bytes);
}

}  // namespace
}  // namespace adit
