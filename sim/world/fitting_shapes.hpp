// Small meshes that fittings are made of. All faces look outward.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adit/sim/world.hpp"
#include "noise.hpp"
#include "rock.hpp"

namespace adit::sim {

/// A tube along a line of points.
void add_tube(const std::vector<Eigen::Vector3f>& line, float radius_m, int sides, RockMaterial material, Mesh& mesh);
/// A broken lump about a place, size_m across.
void add_stone(const Eigen::Vector3f& place, float size_m, SeededRow& row, Mesh& mesh);

}  // namespace adit::sim
