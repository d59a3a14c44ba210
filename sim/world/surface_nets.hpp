// The rock's surface as triangles: naive surface nets (Gibson 1998) over blocks of cells near the surface only.
#pragma once

#include "adit/sim/world.hpp"
#include "rock.hpp"

namespace adit::sim {

/// Meshes the field with cells of cell_m. The same bytes on any number of threads. Materials are filled in.
[[nodiscard]] Mesh mesh_of(const PassageField& field, const CourseConfig& config);

}  // namespace adit::sim
