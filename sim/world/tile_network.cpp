#include "tile_network.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>

namespace adit::sim {
namespace {

using Line = std::vector<Eigen::Vector3d>;

/// Ports of two tiles nearer than this are one place; blockers too, which are set down by eye.
constexpr double kSamePlace_m = 1.5;
constexpr double kStep_m = 0.5;
/// The start lies outside of the mouth and off its middle, as in the paper's simulation (3.1). No further out: there is
/// no ground outside of the tiles, and from here the camera of every rig sees rock alone.
constexpr float kStartOutside_m = 1.0f;
constexpr float kStartAside_m = 1.2f;

Line line_through(const std::vector<Eigen::Vector3d>& corners) {
  Line line{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double length_m = (corners[i] - corners[i - 1]).norm();
    const int steps = std::max(1, static_cast<int>(std::lround(length_m / kStep_m)));
    for (int k = 1; k <= steps; ++k) line.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * k / steps);
  }
  return line;
}

/// A quarter circle from (10, 0) to (0, -10), turned by half a circle if asked.
Line bend(double sign) {
  constexpr double kRadius_m = 10.0;
  constexpr int kSteps = 32;
  Line line;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = 0.5 * std::numbers::pi * (1.0 + static_cast<double>(i) / kSteps);
    line.push_back(
        sign * Eigen::Vector3d(kRadius_m + kRadius_m * std::cos(angle), -kRadius_m + kRadius_m * std::sin(angle), 0.0));
  }
  return line;
}

/// The axes within a tile, in its own frame. Empty for a model that is no known tile.
std::vector<Line> axes_of(std::string_view model) {
  if (model == "tunnel_tile_1" || model == "rough_tunnel_tile_4way_intersection")
    return {line_through({{0, 0, 0}, {10, 0, 0}}), line_through({{0, 0, 0}, {-10, 0, 0}}),
            line_through({{0, 0, 0}, {0, 10, 0}}), line_through({{0, 0, 0}, {0, -10, 0}})};
  if (model == "tunnel_tile_2" || model == "rough_tunnel_tile_90deg_turn") return {bend(1.0)};
  if (model == "tunnel_tile_3") return {bend(1.0), bend(-1.0)};
  // Its branches are niches behind a wall of rubble.
  if (model == "tunnel_tile_4")
    return {line_through({{0, -10, 0}, {0, 10, 0}}), line_through({{10, 0, 0}, {4, 0, 0}}),
            line_through({{-10, 0, 0}, {-4, 0, 0}})};
  if (model == "tunnel_tile_5" || model == "rough_tunnel_tile_straight" || model == "constrained_tunnel_tile_short" ||
      model == "constrained_tunnel_tile_tall")
    return {line_through({{0, -10, 0}, {0, 10, 0}})};
  if (model == "tunnel_tile_6" || model == "rough_tunnel_tile_ramp")
    return {line_through({{0, -10, 0}, {0, -8.7, 0}, {0, 8.7, 5}, {0, 10, 5}})};
  if (model == "tunnel_tile_7" || model == "rough_tunnel_tile_vertical_shaft")
    return {line_through({{0, -10, 0}, {0, 0, 0}, {0, 0, 5}, {0, 10, 5}})};
  return {};
}

bool is_shaft(std::string_view model) {
  return model == "tunnel_tile_7" || model == "rough_tunnel_tile_vertical_shaft";
}

/// Joins lines that end at the same place and makes passages of those that run between nodes.
class NetworkMaker {
 public:
  TileNetwork made_of(const std::vector<PlacedTile>& tiles) {
    for (const PlacedTile& tile : tiles) add_tile(tile);
    for (const PlacedTile& tile : tiles)
      if (tile.model == "tunnel_tile_blocker") block(tile.pose.translation());
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if (is_node(joints_[i])) ends.push_back(i);
    // The entrance first: a flight begins there.
    std::stable_sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
      return entrance_rank(joints_[a]) < entrance_rank(joints_[b]);
    });
    for (const std::size_t end : ends) follow_all(end);
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if (!joints_[i].lines.empty() && !used_[joints_[i].lines.front()]) follow_all(i);  // rings without a node
    return std::move(network_);
  }

 private:
  struct Joint {
    Eigen::Vector3d place;
    std::vector<std::size_t> lines;
    bool is_blocked = false;
    bool is_inner = false;  ///< the inner end of a blind branch
    int node = -1;
  };

  void add_tile(const PlacedTile& tile) {
    const std::vector<Line> axes = axes_of(tile.model);
    if (axes.empty() && tile.model != "tunnel_tile_blocker") network_.unknown.push_back(tile.model);
    if (is_shaft(tile.model)) network_.shafts.push_back(tile.pose.translation().cast<float>());
    for (Line line : axes) {
      for (Eigen::Vector3d& place : line) place = tile.pose * place;
      const std::size_t index = lines_.size();
      for (const std::size_t joint : {joint_at(line.front()), joint_at(line.back())})
        joints_[joint].lines.push_back(index);
      if (tile.model == "tunnel_tile_4" && (line.back() - tile.pose.translation()).norm() < 5.0)
        joints_[joint_at(line.back())].is_inner = true;
      lines_.push_back(std::move(line));
      used_.push_back(false);
    }
  }

  std::size_t joint_at(const Eigen::Vector3d& place) {
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if ((joints_[i].place - place).norm() < kSamePlace_m) return i;
    joints_.push_back({.place = place, .lines = {}});
    return joints_.size() - 1;
  }

  void block(const Eigen::Vector3d& place) {
    for (Joint& joint : joints_)
      if ((joint.place - place).norm() < kSamePlace_m) joint.is_blocked = true;
  }

  static bool is_node(const Joint& joint) { return joint.lines.size() != 2 || joint.is_blocked; }

  static NodeKind kind_of(const Joint& joint) {
    if (joint.is_blocked || joint.is_inner) return NodeKind::kDeadEnd;
    if (joint.lines.size() == 1) return NodeKind::kMouth;
    return joint.lines.size() == 2 ? NodeKind::kBend : NodeKind::kJunction;
  }

  static double entrance_rank(const Joint& joint) {
    return (kind_of(joint) == NodeKind::kMouth ? 0.0 : 1e6) + joint.place.norm();
  }

  int node_of(Joint& joint) {
    if (joint.node < 0) {
      joint.node = static_cast<int>(network_.nodes.size());
      network_.nodes.push_back({kind_of(joint), joint.place.cast<float>()});
    }
    return joint.node;
  }

  void follow_all(std::size_t from) {
    for (const std::size_t line : joints_[from].lines)
      if (!used_[line]) follow(from, line);
  }

  void follow(std::size_t from, std::size_t line) {
    Passage passage;
    passage.from = node_of(joints_[from]);
    std::size_t at = from;
    do {
      used_[line] = true;
      append(lines_[line], joints_[at].place, passage.axis);
      at = other_end(line, at);
      if (is_node(joints_[at]) || at == from) break;
      const auto& lines = joints_[at].lines;
      line = lines[0] == line ? lines[1] : lines[0];
    } while (!used_[line]);
    passage.to = node_of(joints_[at]);
    passage.axis.front().place = network_.nodes[static_cast<std::size_t>(passage.from)].place;
    passage.axis.back().place = network_.nodes[static_cast<std::size_t>(passage.to)].place;
    network_.passages.push_back(std::move(passage));
  }

  std::size_t other_end(std::size_t line, std::size_t from) {
    const std::size_t first = joint_at(lines_[line].front());
    return first == from ? joint_at(lines_[line].back()) : first;
  }

  static void append(const Line& line, const Eigen::Vector3d& from, std::vector<AxisPoint>& axis) {
    const bool forward = (line.front() - from).norm() <= (line.back() - from).norm();
    for (std::size_t i = axis.empty() ? 0 : 1; i < line.size(); ++i) {
      const Eigen::Vector3d& place = forward ? line[i] : line[line.size() - 1 - i];
      axis.push_back({place.cast<float>(), kTileWidth_m, kTileHeight_m});
    }
  }

  std::vector<Line> lines_;
  std::vector<bool> used_;
  std::vector<Joint> joints_;
  TileNetwork network_;
};

}  // namespace

TileNetwork network_of(const std::vector<PlacedTile>& tiles) { return NetworkMaker().made_of(tiles); }

void add_tile_network(const std::vector<PlacedTile>& tiles, World& world) {
  TileNetwork network = network_of(tiles);
  if (network.passages.empty()) return;
  world.nodes = std::move(network.nodes);
  world.passages = std::move(network.passages);
  const std::vector<AxisPoint>& axis = world.passages.front().axis;
  const Eigen::Vector3f way = (axis[1].place - axis[0].place).normalized();
  const Eigen::Vector3f left = Eigen::Vector3f::UnitZ().cross(way).normalized();
  world.start.place = axis[0].place - kStartOutside_m * way + kStartAside_m * left;
  world.start.yaw_rad = std::atan2(way.y(), way.x());
}

}  // namespace adit::sim
