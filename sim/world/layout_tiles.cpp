#include <fmt/format.h>

#include "adit/sim/world_error.hpp"
#include "layout.hpp"
#include "tile_network.hpp"

namespace adit::sim {
namespace {

Mouth mouth_at(const Passage& passage, bool at_start) {
  const auto& axis = passage.axis;
  const AxisPoint& end = at_start ? axis.front() : axis.back();
  const AxisPoint& inner = at_start ? axis[1] : axis[axis.size() - 2];
  const Eigen::Vector3f out = end.place - inner.place;
  return {end.place, Eigen::Vector2f(out.x(), out.y()).normalized(), end.width_m, end.height_m, false};
}

}  // namespace

Layout lay_out_tiles(const CourseConfig& config) {
  std::vector<PlacedTile> tiles;
  for (const TilePlan& plan : config.tiles) {
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    pose.translate(Eigen::Vector3d(plan.x_m, plan.y_m, plan.z_m));
    pose.rotate(Eigen::AngleAxisd(plan.yaw_rad, Eigen::Vector3d::UnitZ()));
    tiles.push_back({plan.model, pose});
  }
  TileNetwork network = network_of(tiles);
  if (!network.unknown.empty())
    throw WorldError(fmt::format("{}: '{}' is no tile that is known here", config.name, network.unknown.front()));
  if (network.passages.empty()) throw WorldError(fmt::format("{}: the tiles hold no passage", config.name));
  Layout layout;
  layout.nodes = std::move(network.nodes);
  layout.passages = std::move(network.passages);
  for (const Eigen::Vector3f& foot : network.shafts) layout.rooms.push_back({foot, kShaftWidth_m, kShaftHeight_m});
  for (const Passage& passage : layout.passages) {
    if (layout.nodes[static_cast<std::size_t>(passage.from)].kind == NodeKind::kMouth)
      layout.mouths.push_back(mouth_at(passage, true));
    if (layout.nodes[static_cast<std::size_t>(passage.to)].kind == NodeKind::kMouth)
      layout.mouths.push_back(mouth_at(passage, false));
  }
  // The first mouth is where the first passage begins.
  if (!layout.mouths.empty()) layout.mouths.front().has_apron = config.apron_m > 0.0;
  return layout;
}

}  // namespace adit::sim
