#include <algorithm>
#include <cmath>
#include <cstring>

#include "adit/region.hpp"
#include "adit/scattering_depth.hpp"

namespace adit {
namespace {

/// Sum of the colour channels of a pixel in grey levels; grey counts once.
unsigned channel_sum(const std::uint8_t* pixel, PixelFormat format, int grey16_depth_bits) {
  if (format == PixelFormat::kGrey8) return pixel[0];
  if (format == PixelFormat::kGrey16) {
    std::uint16_t value = 0;
    std::memcpy(&value, pixel, sizeof value);
    return static_cast<unsigned>(std::min(value >> (grey16_depth_bits - 8), 255));
  }
  return static_cast<unsigned>(pixel[0] + pixel[1] + pixel[2]);
}

}  // namespace

double atmospheric_light(const ImageView& view, int grey16_depth_bits, ConstPlaneView dark, double fraction) noexcept {
  const Histogram histogram = histogram_of(dark);
  const double pixels = static_cast<double>(dark.width) * dark.height;
  const auto wanted = static_cast<std::uint64_t>(std::max(1.0, std::ceil(fraction * pixels)));
  int level = 255;
  std::uint64_t count = histogram[255];
  while (level > 0 && count < wanted) count += histogram[static_cast<std::size_t>(--level)];
  const int step = bytes_per_pixel(view.format);
  std::uint64_t sum = 0;
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      if (dark.row(v)[u] >= level) sum += channel_sum(view.row(v) + u * step, view.format, grey16_depth_bits);
    }
  }
  const double channels = step >= 3 ? 3.0 : 1.0;
  return static_cast<double>(sum) / (channels * static_cast<double>(count));
}

}  // namespace adit
