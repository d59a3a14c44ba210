#include "adit/region.hpp"

#include <algorithm>
#include <cmath>

namespace adit {

Histogram histogram_of(ConstPlaneView plane) noexcept {
  Histogram histogram{};
  for (int v = 0; v < plane.height; ++v) {
    const std::uint8_t* row = plane.row(v);
    for (int u = 0; u < plane.width; ++u) ++histogram[row[u]];
  }
  return histogram;
}

Moments moments_of(ConstPlaneView plane, int last_level, std::vector<std::uint32_t>&) noexcept {
  Moments moments;
  for (int v = 0; v < plane.height; ++v) {
    const std::uint8_t* row = plane.row(v);
    std::uint64_t in_row = 0;
    for (int u = 0; u < plane.width; ++u) {
      if (row[u] > last_level) continue;
      ++in_row;
      moments.m10 += static_cast<std::uint64_t>(u);
      moments.m20 += static_cast<std::uint64_t>(u) * static_cast<std::uint64_t>(u);
    }
    moments.m00 += in_row;
    moments.m01 += in_row * static_cast<std::uint64_t>(v);
    moments.m02 += in_row * static_cast<std::uint64_t>(v) * static_cast<std::uint64_t>(v);
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
