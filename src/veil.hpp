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
  double below_stops = 0.0;    ///< how far the darkest places, a fiftieth of the frame, lie below its median light
  double above_stops = 0.0;    ///< how far the brightest tenth lies above it
  double rock_high = 0.0;      ///< light of rock over that of the veil, exceeded in a tenth of the frame
  bool lobe_in_frame = false;  ///< the veil is brightest at a place in the frame: it is the lamp's beam
  double open_share = 0.0;     ///< of the directions near axis and horizon that show air alone, 0 to 1
};

/// Where through the veil the air alone is seen.
struct AirPlace {
  double u = 0.0;            ///< cells, the middle
  double v = 0.0;            ///< cells
  double half_width = 0.0;   ///< cells, from the spread
  double half_height = 0.0;  ///< cells
};

class VeilFit {
 public:
  VeilFit(const CellGrid& grid, const Camera& camera, const FinderConfig& config);

  /// @param levels  parts of a grey level, cleaned. Allocates nothing.
  [[nodiscard]] VeilSight judge(const CellPlane& levels) noexcept;

  /// Natural logarithms of the light of the blocks of the frame judged last, rows one after the other.
  [[nodiscard]] const std::vector<double>& log_light() const noexcept { return log_; }
  [[nodiscard]] int block() const noexcept { return block_; }  ///< cells along the side

  /// What the rock adds to the veil, as a share of the veil, of the frame judged last. Lamp and lens shape veil and
  /// rock alike, so the share depends on range and rock alone: it falls with range, to nothing where dust hides all.
  /// @param levels  as given to judge(); @param cells  of the same grid; @param rock  binary logarithm of the share,
  /// parts of a stop, not below what noise leaves of it.
  void take_off(const CellPlane& levels, LobeOnCells& cells, CellPlane& rock) const noexcept;

  /// Of the frame judged last: the middle of the directions in which rock adds least to the veil. Allocates nothing.
  [[nodiscard]] AirPlace air_place(const VeilSight& veil) noexcept;

 private:
  void gather(const CellPlane& levels, VeilSight& out) noexcept;
  [[nodiscard]] double log_light_below(double share) const noexcept;
  [[nodiscard]] double open_share() const noexcept;

  LobeTerms lobe_{};                                    ///< of the frame judged last
  int block_;                                           ///< cells along the side of a block
  int width_;                                           ///< blocks
  int height_;                                          ///< blocks
  std::array<double, 4097> log_light_{};                ///< natural, by parts of a level
  std::array<int, 4097> counts_{};                      ///< of the blocks, by parts of a level
  std::array<float, 4097> noise_{};                     ///< of a level's light as a share of it
  std::array<std::int16_t, 8 * 1024 + 1> log_share_{};  ///< by parts of the share, parts of a stop
  std::vector<std::int16_t> columns_;                   ///< sums over the rows of one row of blocks
  std::vector<LobeTerms> terms_;
  std::vector<LobeTerms> fit_terms_;  ///< of every other block of every other row
  std::vector<double> fit_log_;       ///< their light
  std::vector<double> weight_;        ///< of the direction of each block, near the axis
  std::vector<double> prior_;         ///< of the direction of each block as a way on
  std::vector<double> log_;           ///< of the light of each block
  std::vector<double> rock_;          ///< over veil, >= 0
  std::vector<double> order_;         ///< for medians
  std::vector<double> smooth_;        ///< rock_ without its texture
};

}  // namespace adit
