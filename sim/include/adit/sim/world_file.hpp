// Gazebo worlds (.world, .sdf) by libsdformat.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// Which shapes of a model are taken.
enum class Geometry : std::uint8_t {
  kVisual,    ///< what a camera sees; where a link has none, it is not there
  kCollision  ///< what Gazebo's physics touches: often simpler, with flat plates as floors
};

/// How a world file is read.
struct WorldFileConfig {
  /// Folders that hold models (`model://NAME` is NAME in one of them). After these come GAZEBO_MODEL_PATH,
  /// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, and `models` beside the world file.
  std::vector<std::string> models;
  bool world_lights = false;              ///< keep the file's lights as lamps
  Geometry geometry = Geometry::kVisual;  ///< one of the two for all: seen and touched rock are the same
};

/// Reads a world or a model. Models and meshes that cannot be found, and what else is passed over (planes that are
/// endless, height maps, plugins with shapes), stand in World::notes. Each mesh file is read once.
/// Where the models are tiles of known ports, nodes, passages and the start come from them; elsewhere they are empty.
/// @throws WorldError in one line: no such file, broken XML (with its line), an include that leads back to itself, a
///         model:// that leads out of its folder, no faces at all, more than kTriangleMax triangles.
[[nodiscard]] World load_world(const std::string& path, const WorldFileConfig& config = {});

}  // namespace adit::sim
