// How well lit rock encloses each cell: the evidence on which the method `adit` calls a place open.
#pragma once

#include "cell_filters.hpp"

namespace adit {

/// What enclosure_of works in.
struct EnclosureScratch {
  EnclosureScratch(int width, int height);
  CellPlane rock;                                  ///< the light that rays can meet
  std::array<CellPlane, 3> from_below;             ///< of the rays down, down left, down right
  std::array<std::vector<std::int16_t>, 2> along;  ///< of the rays to the left and to the right
  std::array<std::vector<std::int16_t>, 3> from_above;
  std::array<std::vector<std::int16_t>, 3> above_before;
};

/// From each cell eight rays go out. The rise of a ray is how much brighter than the cell the brightest rock on it is,
/// in parts of a stop (kStop), less a little for each cell of the way, so that near rock counts more than far rock.
/// Enclosure is the mean of the second, third and fourth smallest of the eight rises, the fourth with double weight:
/// one ray may slip through a crack, and three may leave by the side of the frame at a loss. A way on is dark and has
/// lit rock round it, so that its rays rise; a corner outside the beam has five rays that never do.
/// @param rim_is_rock  false: rays do not meet what lies at the frame's rim, which may be the lens's own edge, its glow
/// or
///                     a part of the vehicle; a cell there may be open all the same.
/// @param light  in parts of a stop; @param out  0 and more, same units.
void enclosure_of(const CellPlane& light, bool rim_is_rock, EnclosureScratch& scratch, CellPlane& out) noexcept;

/// Cells at each end of a side of so many cells that are the frame's rim.
[[nodiscard]] int rim_of(int cells) noexcept;

}  // namespace adit
