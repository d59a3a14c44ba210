// Meshes from files (STL, OBJ, DAE, PLY), by Assimp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// Which axis of the file points upwards.
enum class MeshUp : std::uint8_t {
  kFile,  ///< what a Collada file says of itself; z for all others
  kX,
  kY,
  kZ
};

/// How a mesh file is read.
struct MeshFileConfig {
  double mesh_scale = 1.0;  ///< metres per unit of the file, 1e-6 to 1e6; a unit that Collada states is undone before
  MeshUp mesh_up = MeshUp::kFile;
};

/// More triangles than this are refused: memory and the ray tree grow with them.
inline constexpr std::size_t kTriangleMax = 8'000'000;

/// A mesh as a world without network: start at the origin, towards +x.
/// @throws WorldError in one line: no such file, not a mesh, no faces, a vertex that is not finite, too large.
[[nodiscard]] World load_mesh(const std::string& path, const MeshFileConfig& config = {});

}  // namespace adit::sim
