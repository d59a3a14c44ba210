#include "adit/node/direction.hpp"

#include <cmath>

namespace adit::node {

Direction direction_of(const Bearing& b) noexcept {
  const double level = std::cos(b.elevation_rad);
  return {level * std::sin(b.azimuth_rad), -std::sin(b.elevation_rad), level * std::cos(b.azimuth_rad)};
}

Quaternion arrow_of(const Bearing& bearing) noexcept {
  // Half way between the two: the shortest rotation from x to d is (x cross d, 1 + x dot d), normalised.
  const Direction d = direction_of(bearing);
  const double w = 1.0 + d.x;
  const double norm = std::sqrt(w * w + d.z * d.z + d.y * d.y);
  if (norm < 1e-9) return {0.0, 0.0, 1.0, 0.0};  // straight back along x: any axis across it will do
  return {0.0, -d.z / norm, d.y / norm, w / norm};
}

}  // namespace adit::node
