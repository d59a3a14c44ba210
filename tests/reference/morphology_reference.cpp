#include "reference/morphology_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>

namespace adit::reference {
namespace {

bool inside(const Plane& plane, int u, int v) { return u >= 0 && v >= 0 && u < plane.width && v < plane.height; }

bool covers(const StructuringElement& element, int du, int dv) {
  return std::abs(du) <= element.half_chord(dv + element.height() / 2);
}

/// `choose` keeps one of two levels; `first` gives way to any.
template <class Choose>
Plane under_element(const Plane& in, const StructuringElement& element, std::uint8_t first, Choose choose) {
  Plane out(in.width, in.height);
  for (int v = 0; v < in.height; ++v) {
    for (int u = 0; u < in.width; ++u) {
      std::uint8_t level = first;
      for (int dv = -(element.height() / 2); dv <= element.height() / 2; ++dv) {
        for (int du = -(element.width() / 2); du <= element.width() / 2; ++du) {
          if (covers(element, du, dv) && inside(in, u + du, v + dv)) level = choose(level, in.at(u + du, v + dv));
        }
      }
      out.at(u, v) = level;
    }
  }
  return out;
}

}  // namespace

Plane::Plane(int width_px, int height_px, std::uint8_t level)
    : width(width_px),
      height(height_px),
      pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), level) {}

Plane::Plane(ConstPlaneView plane) : Plane(plane.width, plane.height) {
  for (int v = 0; v < height; ++v) std::copy_n(plane.row(v), width, pixels.data() + index(0, v));
}

Plane erode(const Plane& in, const StructuringElement& element) {
  return under_element(in, element, 255, [](std::uint8_t a, std::uint8_t b) { return a < b ? a : b; });
}

Plane dilate(const Plane& in, const StructuringElement& element) {
  return under_element(in, element, 0, [](std::uint8_t a, std::uint8_t b) { return a > b ? a : b; });
}

Plane close(const Plane& in, const StructuringElement& element) { return erode(dilate(in, element), element); }

std::vector<int> channels_of(const ImageView& view, int u, int v, int grey16_depth_bits) {
  const std::uint8_t* pixel = view.row(v) + u * bytes_per_pixel(view.format);
  if (view.format == PixelFormat::kGrey8) return {pixel[0]};
  if (view.format == PixelFormat::kGrey16) {
    std::uint16_t value = 0;
    std::memcpy(&value, pixel, sizeof value);
    return {std::min(value >> (grey16_depth_bits - 8), 255)};
  }
  return {pixel[0], pixel[1], pixel[2]};
}

Plane dark_channel(const ImageView& view, int patch_size_px, int grey16_depth_bits) {
  Plane smallest(view.width, view.height);
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const std::vector<int> channels = channels_of(view, u, v, grey16_depth_bits);
      smallest.at(u, v) = static_cast<std::uint8_t>(*std::min_element(channels.begin(), channels.end()));
    }
  }
  return erode(smallest, StructuringElement::rectangle(patch_size_px, patch_size_px));
}

double atmospheric_light(const ImageView& view, int grey16_depth_bits, const Plane& dark, double fraction) {
  std::vector<std::uint8_t> levels = dark.pixels;
  std::sort(levels.begin(), levels.end(), std::greater<>());
  const double wanted = std::max(1.0, std::ceil(fraction * static_cast<double>(levels.size())));
  const std::uint8_t last = levels[static_cast<std::size_t>(wanted) - 1];
  std::uint64_t sum = 0;
  std::uint64_t count = 0;
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      if (dark.at(u, v) < last) continue;
      for (const int level : channels_of(view, u, v, grey16_depth_bits)) {
        sum += static_cast<std::uint64_t>(level);
        ++count;
      }
    }
  }
  return static_cast<double>(sum) / static_cast<double>(count);
}

Histogram histogram_of(const Plane& plane) {
  Histogram histogram{};
  for (const std::uint8_t level : plane.pixels) ++histogram[level];
  return histogram;
}

Moments moments_of(const Plane& plane, int last_level) {
  Moments moments;
  for (int v = 0; v < plane.height; ++v) {
    for (int u = 0; u < plane.width; ++u) {
      if (plane.at(u, v) > last_level) continue;
      const auto u64 = static_cast<std::uint64_t>(u);
      const auto v64 = static_cast<std::uint64_t>(v);
      moments.m00 += 1;
      moments.m10 += u64;
      moments.m01 += v64;
      moments.m20 += u64 * u64;
      moments.m02 += v64 * v64;
    }
  }
  return moments;
}

double fill_of(const Plane& plane, int last_level) {
  const Moments moments = moments_of(plane, last_level);
  if (moments.m00 == 0) return 0.0;
  const auto pixels = static_cast<double>(moments.m00);
  const double mean_u = static_cast<double>(moments.m10) / pixels;
  const double mean_v = static_cast<double>(moments.m01) / pixels;
  double spread_u = 0.0;
  double spread_v = 0.0;
  for (int v = 0; v < plane.height; ++v) {
    for (int u = 0; u < plane.width; ++u) {
      if (plane.at(u, v) > last_level) continue;
      // Each pixel is a square of side 1, whose own variance is 1/12.
      spread_u += (u - mean_u) * (u - mean_u) + 1.0 / 12.0;
      spread_v += (v - mean_v) * (v - mean_v) + 1.0 / 12.0;
    }
  }
  return std::min(1.0, pixels / (12.0 * std::sqrt(spread_u / pixels * (spread_v / pixels))));
}

}  // namespace adit::reference
