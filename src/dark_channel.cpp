#include "adit/dark_channel.hpp"

#include <algorithm>
#include <cstring>

namespace adit {
namespace {

std::uint8_t smallest_channel(const std::uint8_t* pixel, PixelFormat format, int grey16_depth_bits) {
  if (format == PixelFormat::kGrey8) return pixel[0];
  if (format == PixelFormat::kGrey16) {
    std::uint16_t value = 0;
    std::memcpy(&value, pixel, sizeof value);
    return static_cast<std::uint8_t>(std::min(value >> (grey16_depth_bits - 8), 255));
  }
  return std::min({pixel[0], pixel[1], pixel[2]});
}

}  // namespace

void dark_channel(const ImageView& view, const StructuringElement& patch, int grey16_depth_bits, PlaneView out,
                  MorphologyScratch& scratch) noexcept {
  const int step = bytes_per_pixel(view.format);
  for (int v = 0; v < view.height; ++v) {
    const std::uint8_t* from = view.row(v);
    std::uint8_t* to = out.row(v);
    for (int u = 0; u < view.width; ++u) to[u] = smallest_channel(from + u * step, view.format, grey16_depth_bits);
  }
  erode(out, patch, out, scratch);
}

}  // namespace adit
