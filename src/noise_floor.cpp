#include "noise_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace adit {
namespace {

/// Rock at the scale of cells varies by 2 to 6 % where light is ample; from 9 % on noise rules the dark places.
constexpr double kQuiet = 0.05;
constexpr double kNoisy = 0.09;
/// The darkest place is dark, but seldom black: a tenth of it is left to be rock.
constexpr double kFloorMost = 0.9;

}  // namespace

NoiseFloor::NoiseFloor(double gamma) : light_of_(kLevelPartsMax + 1), to_(kLevelPartsMax + 1) {
  for (std::size_t part = 0; part < light_of_.size(); ++part) {
    light_of_[part] = static_cast<float>(std::pow(static_cast<double>(part) / kLevelPartsMax, gamma));
  }
}

double NoiseFloor::noise_share(const CellPlane& levels) noexcept {
  if (levels.width < 3 || levels.height < 3) return 0.0;
  std::int64_t residual = 0, level = 0;
  std::array<std::int16_t, kCellsMax> row_of_differences;
  std::int16_t* __restrict const down = row_of_differences.data();
  for (int v = 1; v + 1 < levels.height; v += 2) {  // every other row: thousands of cells are enough
    const std::int16_t* const above = levels.row(v - 1);
    const std::int16_t* const here = levels.row(v);
    const std::int16_t* const below = levels.row(v + 1);
    // The mask is second differences down of second differences across; both fit 16 bits, so that it becomes vector
    // code.
    for (int u = 0; u < levels.width; ++u) down[u] = static_cast<std::int16_t>(above[u] - 2 * here[u] + below[u]);
    std::int32_t row_residual = 0, row_level = 0;  // at most kCellsMax cells, each below 2^16
    for (int u = 1; u + 1 < levels.width; ++u) {
      const auto across = static_cast<std::int16_t>(down[u - 1] - 2 * down[u] + down[u + 1]);
      row_residual += std::abs(across);
      row_level += here[u];
    }
    residual += row_residual;
    level += row_level;
  }
  if (level == 0) return 0.0;
  // The mask's gain on noise is 6; the mean of a Gaussian's absolute value is sqrt(2 / pi) of its deviation.
  return std::sqrt(std::numbers::pi / 2.0) / 6.0 * static_cast<double>(residual) / static_cast<double>(level);
}

double NoiseFloor::floor_share(double noise_share) noexcept {
  return kFloorMost * std::clamp((noise_share - kQuiet) / (kNoisy - kQuiet), 0.0, 1.0);
}

void NoiseFloor::take_off(double floor_share, std::int16_t least, std::int16_t most, CellPlane& levels) noexcept {
  const float floor = light_of_[static_cast<std::size_t>(floor_share * least)];
  // Light grows with the level, so the levels that are left are met in their order.
  std::size_t left = 0;
  for (auto part = static_cast<std::size_t>(least); part <= static_cast<std::size_t>(most); ++part) {
    const float light = light_of_[part] - floor;
    while (left < part && light_of_[left + 1] <= light) ++left;
    to_[part] = static_cast<std::int16_t>(left);
  }
  for (std::int16_t& value : levels.values) value = to_[static_cast<std::size_t>(value)];
}

}  // namespace adit
