// A smooth lobe of light over the frame: what a lamp that is bolted to the camera, and the lens, make of it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "adit/camera.hpp"
#include "reduced_frame.hpp"

namespace adit {

/// What the logarithm of a lobe is made of: 1, x, y, x^2, y^2 and flood_term. x is -1 at the left edge of the frame and
/// 1 at the right one, y likewise times height / width. Narrow beams are bells, wide ones powers of the cosine; in
/// rendered dust the six leave 0.01 to 0.03, the first five 0.03 with the middle too dark.
inline constexpr std::size_t kLobeTerms = 6;
using LobeTerms = std::array<double, kLobeTerms>;

/// The lobe's logarithm where its terms are `t`; t[0] is 1.
[[nodiscard]] inline double lobe_at(const LobeTerms& c, const LobeTerms& t) noexcept {
  return c[0] + c[1] * t[1] + c[2] * t[2] + c[3] * t[3] + c[4] * t[4] + c[5] * t[5];
}

/// Logarithm of 1 / cos^2 of the angle to the axis: a flood's light and a lens's vignetting fall with powers of the
/// cosine.
[[nodiscard]] double flood_term(const Camera& camera, Pixel at) noexcept;

/// The terms at (x, y), which is the pixel `at`.
[[nodiscard]] LobeTerms lobe_terms(const Camera& camera, double x, double y, Pixel at) noexcept;

/// The lobe with the share `below` of the values under it: quantile regression by reweighted least squares. A lamp's
/// beam has no valley: curvatures above zero are set to zero. Allocates nothing.
/// @param values  as many as terms: natural logarithms of light.
[[nodiscard]] LobeTerms fit_lobe(const std::vector<LobeTerms>& terms, const std::vector<double>& values,
                                 double below) noexcept;

/// Draws lobes on the cells of a grid.
class LobeOnCells {
 public:
  LobeOnCells(const CellGrid& grid, const Camera& camera);

  /// The lobe's logarithm at each cell, rows one after the other.
  /// @param aspect  height / width of what y was measured by. Allocates nothing.
  [[nodiscard]] const std::vector<float>& draw(const LobeTerms& lobe, double aspect) noexcept;

 private:
  int width_;
  std::vector<float> flood_terms_;  ///< of each cell
  std::vector<float> of_column_;    ///< what the lobe owes to each column of cells
  std::vector<float> drawn_;
};

}  // namespace adit
