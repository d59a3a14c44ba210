// A box seen from inside: the plainest tunnel, whose every range is known in closed form.
#pragma once

#include "adit/sim/world.hpp"

namespace adit::sim::test {

/// The box from low to high, two triangles a side, one plain Lambert material of the given albedo. Sides whose bit is
/// set in `open_sides` (-x +x -y +y -z +z = 1 2 4 8 16 32) are left out.
inline World box_world(const Eigen::Vector3f& low, const Eigen::Vector3f& high, float albedo = 0.3f,
                       unsigned open_sides = 0) {
  World world;
  Material plain;
  plain.name = "plain";
  plain.albedo = albedo;
  plain.facet_slope = 0.0f;
  plain.tint = {1.0f, 1.0f, 1.0f};
  world.materials = {plain};
  for (unsigned i = 0; i < 8; ++i)
    world.mesh.vertices.emplace_back((i & 1) ? high.x() : low.x(), (i & 2) ? high.y() : low.y(),
                                     (i & 4) ? high.z() : low.z());
  // Corners of each side, counter-clockwise seen from inside.
  constexpr std::uint32_t kSides[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                          {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
  for (unsigned s = 0; s < 6; ++s) {
    if (open_sides >> s & 1u) continue;
    const auto& q = kSides[s];
    world.mesh.triangles.emplace_back(q[0], q[1], q[2]);
    world.mesh.triangles.emplace_back(q[0], q[2], q[3]);
    world.mesh.materials.insert(world.mesh.materials.end(), 2, std::uint8_t{0});
  }
  return world;
}

}  // namespace adit::sim::test
