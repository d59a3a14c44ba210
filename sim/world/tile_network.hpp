// Tiles of the SubT worlds: where their ports are, and the network that comes of laying them side by side.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// Section of the tunnel tiles.
inline constexpr float kTileWidth_m = 5.3f;
inline constexpr float kTileHeight_m = 3.66f;
/// The shaft in the middle of a tile with a vertical step.
inline constexpr float kShaftWidth_m = 6.2f;
inline constexpr float kShaftHeight_m = 8.7f;

/// A model of a world, by name, and where it lies.
struct PlacedTile {
  std::string model;
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
};

struct TileNetwork {
  std::vector<Node> nodes;  ///< mouths, junctions and dead ends; tiles in a row are one passage
  std::vector<Passage> passages;
  std::vector<Eigen::Vector3f> shafts;  ///< feet of the vertical steps
  std::vector<std::string> unknown;     ///< models that are no known tile
};

/// What the tiles make together. The first passage begins at the mouth that is nearest to the origin.
[[nodiscard]] TileNetwork network_of(const std::vector<PlacedTile>& tiles);

/// Adds nodes, passages and the start to the world where the tiles have known ports; does nothing where none has.
void add_tile_network(const std::vector<PlacedTile>& tiles, World& world);

}  // namespace adit::sim
