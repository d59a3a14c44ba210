// What load_mesh and load_world have in common: one file of triangles with its materials.
#pragma once

#include <string>
#include <vector>

#include "adit/sim/mesh_file.hpp"

namespace adit::sim {

/// Triangles of one file, each with an index into its own materials.
struct MeshPart {
  Mesh mesh;
  std::vector<Material> materials;
};

/// @param is_gazebo  coordinates as Gazebo takes them: units of Collada are applied, its up axis is not.
/// @param submesh    only nodes of this name, as in <submesh><name>; empty: all.
/// @throws WorldError
[[nodiscard]] MeshPart read_mesh_part(const std::string& path, const MeshFileConfig& config, bool is_gazebo,
                                      const std::string& submesh = "");

/// Rock of which nothing is known.
[[nodiscard]] Material unknown_rock(const std::string& name);

}  // namespace adit::sim
