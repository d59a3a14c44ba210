// A tunnel of flat walls along a line of corners, and its layout: plain, closed, without relief.
#pragma once

#include <cmath>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim::test {

/// Walls `width_m` apart and `height_m` high along `line` (at the floor), mitred at the corners, closed at both ends.
/// The first node is a mouth (closed all the same), the last but one point of the line is the goal.
inline World bent_tunnel(const std::vector<Eigen::Vector3f>& line, float width_m, float height_m) {
  World world;
  Material plain;
  plain.name = "plain";
  world.materials = {plain};
  const auto direction = [&line](std::size_t i) { return Eigen::Vector3f((line[i + 1] - line[i]).normalized()); };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3f before = direction(i == 0 ? 0 : i - 1), after = direction(i + 1 == line.size() ? i - 1 : i);
    const Eigen::Vector3f middle = (before + after).normalized();
    const Eigen::Vector3f left(-middle.y(), middle.x(), 0.0f);
    const float half = 0.5f * width_m / middle.dot(after);
    const Eigen::Vector3f up(0, 0, height_m);
    for (const float side : {1.0f, -1.0f}) {
      world.mesh.vertices.push_back(line[i] + side * half * left);
      world.mesh.vertices.push_back(line[i] + side * half * left + up);
    }
  }
  const auto quad = [&world](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    world.mesh.triangles.emplace_back(a, b, c);
    world.mesh.triangles.emplace_back(a, c, d);
    world.mesh.materials.insert(world.mesh.materials.end(), 2, std::uint8_t{0});
  };
  // Vertices of a section: left floor, left roof, right floor, right roof.
  for (std::uint32_t i = 0; i + 1 < line.size(); ++i) {
    const std::uint32_t a = 4 * i, b = a + 4;
    quad(a, b, b + 1, a + 1);
    quad(a + 2, a + 3, b + 3, b + 2);
    quad(a, a + 2, b + 2, b);
    quad(a + 1, b + 1, b + 3, a + 3);
  }
  const auto last = static_cast<std::uint32_t>(4 * (line.size() - 1));
  quad(0, 1, 3, 2);
  quad(last, last + 2, last + 3, last + 1);

  world.start.place = line[0] + 3.0f * direction(0);
  world.start.yaw_rad = std::atan2(direction(0).y(), direction(0).x());
  world.nodes = {
      {NodeKind::kMouth, line.front()}, {NodeKind::kGoal, line[line.size() - 2]}, {NodeKind::kDeadEnd, line.back()}};
  Passage route{0, 1, {}}, rest{1, 2, {}};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) route.axis.push_back({line[i], width_m, height_m});
  rest.axis = {{line[line.size() - 2], width_m, height_m}, {line.back(), width_m, height_m}};
  world.passages = {route, rest};
  return world;
}

}  // namespace adit::sim::test
