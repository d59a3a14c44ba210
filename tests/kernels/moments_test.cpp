// Histogram, moments, centroid and fill against the plain versions, on every CPU target.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "adit/region.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::TargetInUse;
using reference::Content;
using reference::Plane;

::testing::AssertionResult same_moments(const Moments& got, const Moments& want) {
  if (got.m00 == want.m00 && got.m10 == want.m10 && got.m01 == want.m01 && got.m20 == want.m20 && got.m02 == want.m02)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "m00 " << got.m00 << " for " << want.m00 << ", m10 " << got.m10 << " for "
                                       << want.m10 << ", m01 " << got.m01 << " for " << want.m01 << ", m20 " << got.m20
                                       << " for " << want.m20 << ", m02 " << got.m02 << " for " << want.m02;
}

/// The scratch never starts clean, and is no larger than it must be.
std::vector<std::uint32_t> dirty_columns(int width) {
  return std::vector<std::uint32_t>(static_cast<std::size_t>(width), 0xdeadbeefU);
}

TEST(Histogram, AgreesWithThePlainVersionAtEveryWidth) {
  for (int width = 1; width <= 300; width += judging::grid_is_small() ? 13 : 1) {
    const int height = 1 + width * 11 % 40;
    for (const Content content : {Content::kNoise, Content::kFlat, Content::kPiecewise}) {
      const Plane plane = reference::synthetic_plane(content, width, height, static_cast<std::uint64_t>(width));
      const Histogram want = reference::histogram_of(plane);
      for (const std::string_view target : supported_cpu_targets()) {
        const TargetInUse in_use(target);
        ASSERT_EQ(histogram_of(plane.view()), want)
            << width << " x " << height << " px, " << to_string(content) << ", " << target;
      }
    }
  }
}

TEST(Histogram, LeavesTheBytesBetweenRowsOut) {
  const Plane wide = reference::synthetic_plane(Content::kNoise, 200, 30, 1);
  const ConstPlaneView region(wide.pixels.data() + 3, 77, 30, 200);
  const Histogram want = reference::histogram_of(Plane(region));
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    EXPECT_EQ(histogram_of(region), want) << target;
  }
}

TEST(Moments, AgreeWithThePlainVersionAtEveryWidth) {
  for (int width = 1; width <= 300; width += judging::grid_is_small() ? 13 : 1) {
    const int height = 1 + width * 11 % 40;
    const Plane plane = reference::synthetic_plane(Content::kNoise, width, height, static_cast<std::uint64_t>(width));
    for (const int last_level : {0, 1, 100, 127, 128, 129, 254, 255}) {
      const Moments want = reference::moments_of(plane, last_level);
      for (const std::string_view target : supported_cpu_targets()) {
        const TargetInUse in_use(target);
        std::vector<std::uint32_t> columns = dirty_columns(width);
        ASSERT_TRUE(same_moments(moments_of(plane.view(), last_level, columns), want))
            << width << " x " << height << " px, last level " << last_level << ", " << target;
      }
    }
  }
}

TEST(Moments, LeaveTheBytesBetweenRowsOut) {
  const Plane wide = reference::synthetic_plane(Content::kNoise, 200, 30, 2);
  const ConstPlaneView region(wide.pixels.data() + 3, 77, 30, 200);
  const Moments want = reference::moments_of(Plane(region), 90);
  std::vector<std::uint32_t> columns = dirty_columns(500);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    EXPECT_TRUE(same_moments(moments_of(region, 90, columns), want)) << target;
  }
}

// Counters narrower than the count would wrap here: tall, wide, and the largest frame there is.
TEST(Moments, AreExactOnTheLargestPlanes) {
  struct Size {
    int width;
    int height;
  };
  for (const Size size : {Size{16, 8192}, Size{8192, 16}, Size{8192, 8192}}) {
    const Plane plane(size.width, size.height, 7);
    const auto w = static_cast<std::uint64_t>(size.width);
    const auto h = static_cast<std::uint64_t>(size.height);
    const Moments want{w * h, h * (w * (w - 1) / 2), w * (h * (h - 1) / 2), h * ((w - 1) * w * (2 * w - 1) / 6),
                       w * ((h - 1) * h * (2 * h - 1) / 6)};
    for (const std::string_view target : supported_cpu_targets()) {
      const TargetInUse in_use(target);
      SCOPED_TRACE(::testing::Message() << size.width << " x " << size.height << " px, " << target);
      std::vector<std::uint32_t> columns = dirty_columns(size.width);
      EXPECT_TRUE(same_moments(moments_of(plane.view(), 7, columns), want));
      EXPECT_TRUE(same_moments(moments_of(plane.view(), 6, columns), Moments{}));
      Histogram one_level{};
      one_level[7] = static_cast<std::uint32_t>(w * h);
      EXPECT_EQ(histogram_of(plane.view()), one_level);
    }
  }
}

TEST(Centroid, IsTheMeanOfTheRegion) {
  Plane plane(100, 60, 200);
  for (int v = 10; v <= 20; ++v) {
    for (int u = 30; u <= 50; ++u) plane.at(u, v) = 5;
  }
  std::vector<std::uint32_t> columns(100);
  const Pixel centroid = centroid_of(moments_of(plane.view(), 5, columns));
  EXPECT_EQ(centroid.u_px, 40.0);
  EXPECT_EQ(centroid.v_px, 15.0);
}

double fill(const Plane& plane) {
  std::vector<std::uint32_t> columns(static_cast<std::size_t>(plane.width));
  const double fill = fill_of(moments_of(plane.view(), 5, columns));
  EXPECT_NEAR(fill, reference::fill_of(plane, 5), 1e-6);
  return fill;
}

/// Level 0 where `inside(u, v)` holds, else 200.
template <class Inside>
Plane plane_where(int width, int height, Inside inside) {
  Plane plane(width, height, 200);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (inside(u, v)) plane.at(u, v) = 0;
    }
  }
  return plane;
}

TEST(Fill, IsOneForRectanglesAndEllipses) {
  EXPECT_NEAR(fill(plane_where(100, 60, [](int u, int v) { return u > 20 && u < 90 && v > 3 && v < 17; })), 1.0, 1e-9);
  EXPECT_EQ(fill(plane_where(100, 60, [](int u, int v) { return std::hypot((u - 50) / 30.0, (v - 30) / 20.0) < 1.0; })),
            1.0);
}

TEST(Fill, IsOneForAPixelAndForALineFarFromTheOrigin) {
  EXPECT_NEAR(fill(plane_where(2000, 1500, [](int u, int v) { return u == 1998 && v == 1499; })), 1.0, 1e-6);
  EXPECT_NEAR(fill(plane_where(2000, 1500, [](int u, int) { return u == 1999; })), 1.0, 1e-6);
}

TEST(Fill, IsNearlyZeroForTwoBlobsFarApart) {
  EXPECT_LT(fill(plane_where(640, 480, [](int u, int v) { return (u < 20 && v < 20) || (u > 619 && v > 459); })), 0.01);
}

TEST(Fill, IsZeroOfNothing) { EXPECT_EQ(fill(Plane(20, 20, 200)), 0.0); }

TEST(Fill, AgreesWithThePlainVersion) {
  for (const Content content : reference::kContents) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      Plane plane = reference::synthetic_plane(content, 120, 90, seed);
      for (std::uint8_t& level : plane.pixels) level /= 16;
      fill(plane);
    }
  }
}

}  // namespace
}  // namespace adit
