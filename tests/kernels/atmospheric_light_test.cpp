// The atmospheric light against the plain version, to the last bit, on every CPU target.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "adit/dark_channel.hpp"
#include "adit/scattering_depth.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::TargetInUse;
using reference::Content;
using reference::Frame;
using reference::Layout;
using reference::Plane;

constexpr double kFractions[] = {1.0, 0.5, 0.07, 0.001, 1e-9, 1.0 / 3.0};

void judge(const ImageView& view, int depth_bits, const Plane& dark) {
  for (const double fraction : kFractions) {
    const double want = reference::atmospheric_light(view, depth_bits, dark, fraction);
    for (const std::string_view target : supported_cpu_targets()) {
      const TargetInUse in_use(target);
      ASSERT_EQ(atmospheric_light(view, depth_bits, dark.view(), fraction), want)
          << view.width << " x " << view.height << " px, fraction " << fraction << ", " << target;
    }
  }
}

class AtmosphericLightOfFormat : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(AtmosphericLightOfFormat, AgreesWithThePlainVersion) {
  constexpr Layout kLayouts[] = {{0, false}, {10, false}, {2, true}};
  for (int width = 16; width <= 80; width += judging::grid_is_small() ? 9 : 1) {
    const auto seed = static_cast<std::uint64_t>(width);
    const int height = 16 + width * 7 % 11;
    const Content content = reference::kContents[reference::hash_of(seed) % 6];
    const int depth_bits = 8 + width % 9;
    const Frame frame(content, GetParam(), width, height, seed, kLayouts[seed % 3]);
    const Plane dark = reference::dark_channel(frame.view(), 1 + width % 3 * 2, depth_bits);
    SCOPED_TRACE(to_string(content));
    ASSERT_NO_FATAL_FAILURE(judge(frame.view(), depth_bits, dark));
  }
}

TEST_P(AtmosphericLightOfFormat, AgreesWithThePlainVersionOnALargerFrame) {
  for (const Content content : {Content::kNoise, Content::kTunnel}) {
    const Frame frame(content, GetParam(), 331, 203, 4);
    ASSERT_NO_FATAL_FAILURE(judge(frame.view(), 12, reference::dark_channel(frame.view(), 3, 12)));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, AtmosphericLightOfFormat, ::testing::ValuesIn(reference::kFormats),
                         [](const auto& format) { return std::string(reference::to_string(format.param)); });

/// 16 x 16 grey pixels that rise by one in reading order, and a dark channel of their own.
struct Ramp {
  Frame frame{Content::kFlat, PixelFormat::kGrey8, 16, 16, 0};
  Plane dark{16, 16};
  Ramp() {
    for (std::size_t i = 0; i < 256; ++i) frame.bytes()[i] = static_cast<std::uint8_t>(i);
  }
  [[nodiscard]] double light(double fraction) const {
    return atmospheric_light(frame.view(), 16, dark.view(), fraction);
  }
};

TEST(AtmosphericLight, TiesWithTheLastPixelAllCount) {
  Ramp ramp;
  // Pixels 0 to 99 tie; 200 alone is above them. Two are wanted: 200 and all hundred.
  for (std::size_t i = 0; i < 100; ++i) ramp.dark.pixels[i] = 50;
  ramp.dark.pixels[200] = 60;
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    EXPECT_EQ(ramp.light(1.0 / 256.0), 200.0) << target;
    EXPECT_EQ(ramp.light(2.0 / 256.0), (99.0 * 100.0 / 2.0 + 200.0) / 101.0) << target;
  }
}

TEST(AtmosphericLight, AllPixelsAtFractionOneAndOnePixelAtTheSmallest) {
  Ramp ramp;
  for (std::size_t i = 0; i < 256; ++i) ramp.dark.pixels[i] = static_cast<std::uint8_t>(255 - i);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    EXPECT_EQ(ramp.light(1.0), 127.5) << target;
    EXPECT_EQ(ramp.light(1e-300), 0.0) << target << ": the brightest dark channel is the first pixel's, which is black";
  }
}

TEST(AtmosphericLight, BlackAndWhiteFrames) {
  for (const PixelFormat format : reference::kFormats) {
    for (const std::uint8_t byte : {std::uint8_t{0}, std::uint8_t{255}}) {
      Frame frame(Content::kFlat, format, 67, 19, 0);
      for (std::uint8_t& each : frame.bytes()) each = byte;
      for (const std::string_view target : supported_cpu_targets()) {
        const TargetInUse in_use(target);
        const double light = atmospheric_light(frame.view(), 16, Plane(67, 19, byte).view(), 0.001);
        EXPECT_EQ(light, byte) << reference::to_string(format) << ", " << target;
      }
    }
  }
}

}  // namespace
}  // namespace adit
