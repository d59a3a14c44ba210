#include "spread_pixels.hpp"

#include <algorithm>
#include <cstring>

namespace adit {
namespace {

int grey16_at(const std::uint8_t* at) noexcept {
  std::uint16_t value = 0;  // at any address
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Planes one after the other: the compiler makes vector code of it.
void least_of_planes(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, std::uint8_t* __restrict to,
                     int count) noexcept {
  for (int u = 0; u < count; ++u) to[u] = std::min(std::min(a[u], b[u]), c[u]);
}

}  // namespace

void spread_minimum(const ImageView& view, const std::uint8_t* from, int shift, std::uint8_t* to, int count) noexcept {
  const std::ptrdiff_t step = view.pixel_step(), next = view.channel_step();
  switch (bytes_per_pixel(view.format)) {
    case 1:
      for (int u = 0; u < count; ++u) to[u] = from[u * step];
      return;
    case 2:
      for (int u = 0; u < count; ++u)
        to[u] = static_cast<std::uint8_t>(std::min(grey16_at(from + u * step) >> shift, 255));
      return;
    default:
      if (step == 1) return least_of_planes(from, from + next, from + 2 * next, to, count);
      for (int u = 0; u < count; ++u) {
        const std::uint8_t* const pixel = from + u * step;
        to[u] = std::min(std::min(pixel[0], pixel[next]), pixel[2 * next]);
      }
  }
}

void gather_pixels(const ImageView& view, const std::uint8_t* from, std::uint8_t* to, int count) noexcept {
  const std::ptrdiff_t step = view.pixel_step(), next = view.channel_step();
  const int bytes = bytes_per_pixel(view.format);
  if (bytes < 3) {
    for (int u = 0; u < count; ++u, to += bytes) std::memcpy(to, from + u * step, static_cast<std::size_t>(bytes));
    return;
  }
  for (int u = 0; u < count; ++u)
    for (int channel = 0; channel < bytes; ++channel) *to++ = from[u * step + channel * next];
}

}  // namespace adit
