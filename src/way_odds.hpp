// A way on, or a wall? The odds, from what one frame shows (method `adit`).
#pragma once

#include "opening_search.hpp"
#include "veil.hpp"

namespace adit {

/// Natural logarithm of the odds that `best` is a way on and not a dark place on a wall, where both are equally
/// likely beforehand. For a way on speak a deep place and a wide one; shading that only a cusp explains (cusp.hpp);
/// directions near axis and horizon in which hardly any rock is seen; and a bright end of the frame far above its
/// median, since near rock and far rock are lit unalike. A wall is lit alike but for what the lamp leaves dark, so that
/// its dark end lies far below.
/// @param cells     of the grid. @param cusp  CuspFit::most() for the first place, share_at() for another.
/// @param veil_off  the light searched was rock over veil.
[[nodiscard]] double way_odds(const Candidate& best, int cells, const VeilSight& veil, double cusp,
                              bool veil_off) noexcept;

}  // namespace adit
