// A door that keeps a flight inside.
#pragma once

#include "adit/sim/world.hpp"

namespace adit::sim {

/// Metres behind the start at which the door stands: the vehicle's body (0.25 m) is clear of it wherever seeds put it.
inline constexpr double kDoorBehind_m = 0.7;

/// Shuts the passage behind the start with a wall of steel, as a ventilation door does in a mine: nobody leaves by the
/// way that he came in by, and what was a mouth is one more dead end. Where the layout is known the door is as wide and
/// as high as the passage, and a metre more on every side, else 10 m wide and 8 m high about the start. It is part of
/// the mesh: it is seen, measured and touched as rock is.
/// @throws std::invalid_argument when the world has 255 materials already
void close_behind_start(World& world);

}  // namespace adit::sim
