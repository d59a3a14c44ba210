// Uses adit::sim without naming its libraries.
#include <adit/sim/render.hpp>
#include <adit/sim/world.hpp>

/// Linked, so that what the simulator stands on has to be found.
std::size_t presets() { return adit::sim::rig_preset_names().size(); }
