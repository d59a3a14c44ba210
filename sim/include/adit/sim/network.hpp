// Where one is in the passages of a world, what lies ahead, and how far it is to the goal.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// A place on the axis of a passage.
struct AxisPlace {
  int passage = -1;      ///< index into World::passages
  double along_m = 0.0;  ///< from the passage's first node
  double aside_m = 0.0;  ///< distance of the point that was asked for from the axis' vertical, horizontally
  Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< on the axis, at the floor
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();  ///< unit, towards the passage's last node
  double width_m = 0.0;
  double height_m = 0.0;
};

/// Where one comes to who goes on for some way.
struct Ahead {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the axis, at the floor
  int passage = -1;
  bool at_end = false;             ///< the way ended before its length, at a dead end or a mouth
  NodeKind end = NodeKind::kBend;  ///< which of them, where at_end
};

/// The axes of a world's passages as a graph. Worlds whose layout is not known give an empty one.
class Network {
 public:
  Network() = default;
  /// Copies what it needs of nodes and passages. Passages that name a node that is not there are passed over.
  explicit Network(const World& world);

  [[nodiscard]] bool empty() const noexcept { return passages_.empty(); }
  [[nodiscard]] bool has_goal() const noexcept { return has_goal_; }

  /// The place of the network closest to a point. The network must not be empty.
  [[nodiscard]] AxisPlace nearest(const Eigen::Vector3d& point) const;

  /// Whether a place is the very end of a passage, at a mouth: points beyond it are outside.
  [[nodiscard]] bool is_mouth(const AxisPlace& place) const;

  /// Way along the axes to the nearest goal, m; infinity where none can be reached.
  [[nodiscard]] double to_goal_m(const AxisPlace& from) const;
  /// Way along the axes between two places, m; infinity where there is none.
  [[nodiscard]] double between_m(const AxisPlace& from, const AxisPlace& to) const;

  /// All places that are length_m further along the axes, for who leaves `from` in the direction of `heading` (only its
  /// component along the axis counts) and never turns back: one for each branch.
  [[nodiscard]] std::vector<Ahead> ahead(const AxisPlace& from, const Eigen::Vector3d& heading, double length_m) const;

  /// One place in each branch that is less than range_m ahead: `into_m` past the wall of the junction it leaves.
  [[nodiscard]] std::vector<Ahead> branches(const AxisPlace& from, const Eigen::Vector3d& heading, double range_m,
                                            double into_m) const;

 private:
  struct Line {
    int from = -1;
    int to = -1;
    std::vector<AxisPoint> axis;
    std::vector<double> along_m;  ///< of each point of the axis
    [[nodiscard]] double length_m() const { return along_m.back(); }
  };
  struct Walk;

  [[nodiscard]] AxisPlace at(int passage, double along_m) const;
  void distances_from(std::vector<double>& ways_m) const;
  void walk(const Walk& walk, std::vector<Ahead>& found) const;
  void walk_into_branches(const Walk& walk, double into_m, std::vector<Ahead>& found) const;

  std::vector<Node> nodes_;
  std::vector<Line> passages_;
  std::vector<int> source_index_;           ///< of each line, in World::passages
  std::vector<std::vector<int>> lines_at_;  ///< of each node
  std::vector<double> goal_ways_m_;         ///< of each node
  bool has_goal_ = false;
};

}  // namespace adit::sim
