// The cusp: how a passage's light falls towards its far end (method `adit`).
//
// Seen along a tube of radius R with the lamp beside the camera, rock at the angle a from the axis is R / sin(a) away
// and is met at the angle a: its light goes as a power of sin(a), a cusp about the direction of the passage, steepest
// where it is darkest. A wall ahead, the lamp's lobe and the lens's vignetting are smooth: over a frame a quadratic of
// x and y holds them. So the share of the frame's shading that no quadratic explains and a cusp does tells passages
// from walls, and where it is largest the passage lies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adit/camera.hpp"
#include "reduced_frame.hpp"

namespace adit {

class CuspFit {
 public:
  /// @param block  cells along the side of a block of light.
  CuspFit(const CellGrid& grid, const Camera& camera, int block, double horizon_spread_deg);

  /// @param log_light  natural logarithms of the light of the blocks, rows one after the other. Allocates nothing.
  void judge(const std::vector<double>& log_light) noexcept;

  /// Of the frame judged last: the largest share of the shading without its quadratic that a cusp explains, 0 to 1, of
  /// directions near the horizon. A frame of too few blocks to tell has what walls and passages share.
  [[nodiscard]] double most() const noexcept { return most_; }

  /// Of the frame judged last: the same share of a cusp about one place, cells; at most most().
  [[nodiscard]] double share_at(double u, double v) noexcept;

  /// How much a place counts that has no cusp about it beside one that has: a third at the least.
  /// @param v  row of cells. @return for each of its cells, 0 to 256; valid until the next call.
  [[nodiscard]] const std::vector<std::int16_t>& weights_of_row(int v) noexcept;

 private:
  /// Where the middle of a cell lies between the middles of two patches that follow each other.
  struct Between {
    int first;   ///< patch
    float part;  ///< of the way to the next, 0 to 1
  };
  static std::vector<Between> places(int cells, int patch, int patches);
  void make_quadratics();
  /// @param bearings  of the middles of the patches.
  void draw_cusps(const std::vector<Bearing>& bearings);
  void take_quadratic(float* values) const noexcept;
  void average(const std::vector<double>& log_light) noexcept;
  void rate_directions() noexcept;

  int stride_;  ///< blocks along the side of a patch
  int blocks_;  ///< along a row
  int patch_;   ///< cells along the side of a patch
  int width_;   ///< patches
  int height_;  ///< patches
  double most_;
  std::vector<float> quadratics_;  ///< six orthonormal ones, each of all patches
  std::vector<float> cusps_;       ///< [patch][direction]: about the middle of each patch, without their quadratics
  std::vector<float> prior_;       ///< of the directions, by elevation
  std::vector<float> shading_;     ///< of the frame judged last, without its quadratic
  std::vector<float> share_;       ///< of the shading that a cusp there explains
  std::vector<float> weight_;      ///< of each patch row at each cell of a row, 0 to 256
  std::vector<Between> of_u_;      ///< of each column of cells
  std::vector<Between> of_v_;
  std::vector<std::int16_t> row_;
};

}  // namespace adit
