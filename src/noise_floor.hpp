// Noise that stands where no light does. A sensor at full gain shows levels well above zero in the dark: noise cannot
// fall below zero, the tone curve lifts what is left, and its mean is a floor under the whole frame.
#pragma once

#include <vector>

#include "reduced_frame.hpp"

namespace adit {

/// Finds the floor by the noise that makes it, and takes it off. In dust the darkest place stands on a veil, which is
/// as bright but quiet: it is left to VeilFit.
class NoiseFloor {
 public:
  /// @param gamma  exponent from grey level to light, as in FinderConfig::light_gamma
  explicit NoiseFloor(double gamma);

  /// Standard deviation of the noise of single cells as a share of their mean level, 0 for a black frame. Even planes
  /// do not count, nor do edges (they are few): Immerkaer, Fast noise variance estimation (1996), eq. 1 to 3.
  /// @param levels  at most kCellsMax wide
  [[nodiscard]] static double noise_share(const CellPlane& levels) noexcept;

  /// The share of the darkest light that is floor: 0 where the frame is quiet, kFloorMost where it is mostly noise.
  [[nodiscard]] static double floor_share(double noise_share) noexcept;

  /// Takes off, in light, the given share of the smallest level there is. Levels stay levels of the same tone curve.
  /// @param least,most  the smallest and the largest of `levels`
  void take_off(double floor_share, std::int16_t least, std::int16_t most, CellPlane& levels) noexcept;

 private:
  std::vector<float> light_of_;  // of each part of a level
  std::vector<std::int16_t> to_;
};

}  // namespace adit
