#include "adit/region.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/pixel_loops.hpp"

namespace adit {

Histogram histogram_of(ConstPlaneView plane) noexcept {
  Histogram histogram{};
  kernels::pixel_loops().count_levels(plane.data, plane.stride_bytes, plane.width, plane.height, histogram.data());
  return histogram;
}

Moments moments_of(ConstPlaneView plane, int last_level, std::vector<std::uint32_t>& columns) noexcept {
  Moments moments;
  if (last_level < 0) return moments;
  // The loops count in bytes, which hold 255 rows.
  constexpr int kRowsAtATime = 255;
  std::fill(columns.begin(), columns.end(), 0u);
  std::array<std::uint8_t, kSideMax_px> bytes;
  std::array<std::uint32_t, kRowsAtATime> rows;
  const auto level = static_cast<std::uint8_t>(std::min(last_level, 255));
  for (int begin = 0; begin < plane.height; begin += kRowsAtATime) {
    const int height = std::min(kRowsAtATime, plane.height - begin);
    std::fill_n(bytes.begin(), plane.width, std::uint8_t{0});
    kernels::pixel_loops().count_mask(plane.row(begin), plane.stride_bytes, plane.width, height, level, bytes.data(),
                                      rows.data());
    for (int u = 0; u < plane.width; ++u) columns[static_cast<std::size_t>(u)] += bytes[static_cast<std::size_t>(u)];
    for (int i = 0; i < height; ++i) {
      const std::uint64_t in_row = rows[static_cast<std::size_t>(i)];
      const auto v = static_cast<std::uint64_t>(begin + i);
      moments.m00 += in_row;
      moments.m01 += in_row * v;
      moments.m02 += in_row * v * v;
    }
  }
  for (int u = 0; u < plane.width; ++u) {
    const std::uint64_t in_column = columns[static_cast<std::size_t>(u)];
    const auto at = static_cast<std::uint64_t>(u);
    moments.m10 += in_column * at;
    moments.m20 += in_column * at * at;
  }
  return moments;
}

Pixel centroid_of(const Moments& moments) noexcept {
  const auto m00 = static_cast<double>(moments.m00);
  return {static_cast<double>(moments.m10) / m00, static_cast<double>(moments.m01) / m00};
}

double fill_of(const Moments& moments) noexcept {
  if (moments.m00 == 0) return 0.0;
  const auto m00 = static_cast<double>(moments.m00);
  const Pixel mean = centroid_of(moments);
  // A pixel is a square, not a point: its own spread (1/12 px^2) makes thin and tiny regions come out right.
  const double variance_u = static_cast<double>(moments.m20) / m00 - mean.u_px * mean.u_px + 1.0 / 12.0;
  const double variance_v = static_cast<double>(moments.m02) / m00 - mean.v_px * mean.v_px + 1.0 / 12.0;
  const double box = 12.0 * std::sqrt(std::max(variance_u, 1.0 / 12.0) * std::max(variance_v, 1.0 / 12.0));
  return std::min(1.0, m00 / box);
}

}  // namespace adit
