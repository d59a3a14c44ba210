// The veil: the lamp's own light thrown back by dust between camera and rock (method `adit`).
//
// What the air alone sends is smooth: a lobe about the lamp's axis, brightest where the beam is. Rock adds to it, and
// never takes away. So the veil is the lower envelope of the frame: in clear air it lies far below the rock, in dust
// the frame lies close to it.
#pragma once

#include <array>
#include <vector>

#include "adit/camera.hpp"
#include "adit/finder.hpp"
#include "lobe.hpp"
#include "reduced_frame.hpp"

namespace adit {

/// What the veil tells of a frame.
struct VeilSight {
  double fraction = 0.0;       ///< median over the frame of veil / (veil + rock), 0 to 1
  double undercut = 1.0;       ///< light of the darkest places over the lobe there, at most 1: no veil is brighter
  double rock_high = 0.0;      ///< light of rock over that of the veil, exceeded in a tenth of the frame
  bool lobe_in_frame = false;  ///< the veil is brightest at a place in the frame: it is the lamp's beam
  // The way on, as far as it can be seen through the veil: where the air alone is seen, near the axis and the horizon.
  double u = 0.0;              ///< cells
  double v = 0.0;              ///< cells
  double half_width = 0.0;     ///< cells, from the spread
  double half_height = 0.0;    ///< cells
  double open_share = 0.0;     ///< of the directions near axis and horizon that show air alone, 0 to 1
  double rock_at_place = 0.0;  ///< mean light of rock over that of the veil about (u, v)
};

class VeilFit {
 public:
  VeilFit(const CellGrid& grid, const Camera& camera, const FinderConfig& config);

  /// @param levels  parts of a grey level, cleaned. Allocates nothing.
  [[nodiscard]] VeilSight judge(const CellPlane& levels) noexcept;

  /// What the rock adds to the veil, as a share of the veil, of the frame judged last. Lamp and lens shape veil and
  /// rock alike, so the share depends on range and rock alone: it falls with range, to nothing where dust hides all.
  /// @param levels  as given to judge(); @param cells  of the same grid; @param rock  binary logarithm of the share,
  /// parts of a stop, not below what noise leaves of it.
  void take_off(const CellPlane& levels, LobeOnCells& cells, CellPlane& rock) const noexcept;

 private:
  void gather(const CellPlane& levels) noexcept;
  void place(VeilSight& out) noexcept;

  LobeTerms lobe_{};                                    ///< of the frame judged last
  int block_;                                           ///< cells along the side of a block
  int width_;                                           ///< blocks
  int height_;                                          ///< blocks
  std::array<double, 4097> log_light_{};                ///< by parts of a level
  std::array<float, 4097> noise_{};                     ///< of a level's light as a share of it
  std::array<std::int16_t, 8 * 1024 + 1> log_share_{};  ///< by parts of the share, parts of a stop
  std::vector<LobeTerms> terms_;
  std::vector<LobeTerms> fit_terms_;  ///< of every other block of every other row
  std::vector<double> fit_log_;       ///< their light
  std::vector<double> weight_;        ///< of the direction of each block
  std::vector<double> log_;           ///< of the light of each block
  std::vector<double> rock_;          ///< over veil, >= 0
  std::vector<double> order_;         ///< for medians
};

}  // namespace adit
