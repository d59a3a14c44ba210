// Many rays from one point, a packet at a time.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adit/sim/scene.hpp"

namespace adit::sim {

/// Range of each ray from `origin` along its unit direction, m; range_max_m where nothing is met.
inline std::vector<float> ranges_from(const RayScene& scene, const Eigen::Vector3f& origin,
                                      const std::vector<Eigen::Vector3f>& directions, float range_max_m) {
  std::vector<float> ranges(directions.size(), range_max_m);
  RayPacket rays{};
  HitPacket hits{};
  for (std::size_t first = 0; first < directions.size(); first += kPacket) {
    const std::size_t count = std::min<std::size_t>(kPacket, directions.size() - first);
    for (std::size_t i = 0; i < kPacket; ++i) {
      const Eigen::Vector3f& direction = directions[i < count ? first + i : first];
      for (int k = 0; k < 3; ++k) {
        rays.origin[k][i] = origin[k];
        rays.direction[k][i] = direction[k];
      }
      rays.tnear[i] = 0.0f;
      rays.tfar[i] = i < count ? range_max_m : -1.0f;
    }
    scene.intersect(rays, hits);
    for (std::size_t i = 0; i < count; ++i)
      if (hits.triangle[i] != kNoTriangle) ranges[first + i] = hits.t[i];
  }
  return ranges;
}

}  // namespace adit::sim
