// The plan of a course before there is rock: nodes, passage axes, rooms, mouths. Every kind of course (moves, random,
// tiles) becomes one of these, and the rock is built from it alone.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "adit/sim/course.hpp"
#include "adit/sim/world.hpp"

namespace adit::sim {

/// A round room: a passage of length zero.
struct Room {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();  ///< middle of its floor
  float width_m = 0.0f;
  float height_m = 0.0f;
};

/// Where a passage meets the open air: the rock ends at this upright plane.
struct Mouth {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();      ///< on the floor
  Eigen::Vector2f outward = -Eigen::Vector2f::UnitX();  ///< unit, horizontal
  float width_m = 0.0f;
  float height_m = 0.0f;
  bool has_apron = false;  ///< ground and a rock face outside
};

struct Layout {
  std::vector<Node> nodes;
  std::vector<Passage> passages;
  std::vector<Room> rooms;
  std::vector<Mouth> mouths;
  StartPose start;
};

/// Lays the course out. @throws WorldError naming the passage and what is wrong with it.
[[nodiscard]] Layout lay_out(const CourseConfig& config);

/// The three kinds of layout, see LayoutKind.
[[nodiscard]] Layout lay_out_moves(const CourseConfig& config);
[[nodiscard]] Layout lay_out_random(const CourseConfig& config);
[[nodiscard]] Layout lay_out_network(const CourseConfig& config);
[[nodiscard]] Layout lay_out_tiles(const CourseConfig& config);

/// A place with a direction, from which the next stretch of axis is laid.
struct AxisHead {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  double width_m = 5.0;
  double height_m = 3.5;
};

/// Appends the axis of one move to `axis` (which ends at the head's place, or is empty) and moves the head on.
void append_move(const Move& move, AxisHead& head, std::vector<AxisPoint>& axis);

}  // namespace adit::sim
