#include "adit/scattering_depth.hpp"

#include <algorithm>
#include <cmath>

namespace adit {

LevelTable transmission_table(double atmospheric_light, double omega, double transmission_min) noexcept {
  LevelTable transmission{};
  transmission.fill(1.0);
  if (!(atmospheric_light > 0.0)) return transmission;
  for (std::size_t level = 0; level < transmission.size(); ++level) {
    const double t = 1.0 - omega * (static_cast<double>(level) / atmospheric_light);
    transmission[level] = std::max(t, transmission_min);
  }
  return transmission;
}

LevelTable scattering_depth_table(const LevelTable& transmission, double scattering_coefficient) noexcept {
  LevelTable depth{};
  for (std::size_t level = 0; level < depth.size(); ++level) {
    // 0 - x and not -x, so that a transmission of 1 gives depth 0 and not -0. The floor of the transmission fills the
    // upper levels with one value: its logarithm is taken once.
    const bool as_before = level > 0 && transmission[level] == transmission[level - 1];
    depth[level] = as_before ? depth[level - 1] : (0.0 - std::log(transmission[level])) / scattering_coefficient;
  }
  return depth;
}

}  // namespace adit
