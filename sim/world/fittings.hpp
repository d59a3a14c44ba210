// What people have left in the passage: pipes, cables, a duct, props along the walls; and stones on the floor.
#pragma once

#include "adit/sim/world.hpp"
#include "passage_field.hpp"

namespace adit::sim {

/// Adds them to the rock's mesh, seeded; the same bytes on any number of threads.
void add_fittings(const PassageField& field, const CourseConfig& config, const Layout& layout, Mesh& mesh);

}  // namespace adit::sim
