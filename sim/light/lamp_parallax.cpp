// A lamp beside the lens shifts what lies near against what lies far, along lines in the image that are parallel once
// the image is turned so that its plane holds the way from lens to lamp, as the two images of a stereo camera are. By
// a step of focal * baseline / depth: a place is in the dark where something else comes to lie over it. So what the
// camera sees tells which few blocks of pixels are worth rays to the lamp at all.
#include <algorithm>
#include <cmath>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;

/// What stands beyond the image's edge is not seen. Where it might matter if it were no nearer than that, rays decide.
constexpr float kNearestBeyondEdge_m = 1.0f;
constexpr float kTurnMax =
    0.7f;  ///< sine of the turn of the image plane; lamps farther before the lens are not beside it
constexpr float kForwardMin = 0.2f;  ///< cosine between a ray and the turned axis
constexpr float kGrowthMax = 3.0f;   ///< of the number of pixels by the turn

/// The turned frame: x from lens to lamp.
struct Turned {
  Vector3f x, y, z;
  explicit Turned(const Vector3f& lamp) : x(lamp.normalized()) {
    z = (Vector3f::UnitZ() - x.z() * x).normalized();
    y = z.cross(x);
  }
};

struct Extent {
  float low = 1e9f, high = -1e9f;
  void add(float v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] int count() const { return static_cast<int>(std::ceil(high - low)) + 1; }
};

/// Extents of the turned image, px; false where a ray runs too far aside of its axis.
bool extents_of(const Renderer::Parts& parts, const Turned& turned, float focal_px, Extent& along, Extent& across) {
  for (int v = 0; v < parts.height; ++v)
    for (int u = 0; u < parts.width; ++u) {
      if (u != 0 && v != 0 && u != parts.width - 1 && v != parts.height - 1) continue;
      const Vector3f ray = parts.ray_of(u, v);
      const float z = turned.z.dot(ray);
      if (z < kForwardMin) return false;
      along.add(focal_px * turned.x.dot(ray) / z);
      across.add(focal_px * turned.y.dot(ray) / z);
    }
  return true;
}

/// As in ParallaxTable::block.
std::int32_t blocks_about(const Renderer::Parts& parts, int u, int v) {
  const int u0 = std::max(u - 1, 0) / kBlock, u1 = std::min(u + 1, parts.stride - 1) / kBlock;
  const int v0 = std::max(v - 1, 0) / kBlock, v1 = std::min(v + 1, parts.rows - 1) / kBlock;
  return 4 * (v0 * (parts.stride / kBlock) + u0) + (u1 - u0) + 2 * (v1 - v0);
}

}  // namespace

ParallaxTable parallax_of(const Vector3f& lamp, const Renderer::Parts& parts) {
  const float baseline_m = lamp.norm();
  if (baseline_m < 1e-4f || std::abs(lamp.z()) > kTurnMax * baseline_m) return {};
  const Turned turned(lamp);
  const float focal_px = 1.0f / parts.pixel_angle;
  Extent along, across;
  if (!extents_of(parts, turned, focal_px, along, across)) return {};
  const double growth =
      static_cast<double>(along.count()) * across.count() / (static_cast<double>(parts.width) * parts.height);
  if (growth > static_cast<double>(kGrowthMax)) return {};
  ParallaxTable table;
  table.steps = along.count();
  table.lines = (across.count() + kTreeWidth - 1) / kTreeWidth * kTreeWidth;
  table.pixel.assign(static_cast<std::size_t>(table.steps) * table.lines, -1);
  table.shift_m.assign(table.pixel.size(), 0.0f);
  table.block.assign(table.pixel.size(), 0);
  table.edge.assign(static_cast<std::size_t>(table.lines), 1e9f);
  for (int step = table.steps - 1; step >= 0; --step)
    for (int line = 0; line < table.lines; ++line) {
      const Vector3f ray = (along.low + static_cast<float>(step)) * turned.x +
                           (across.low + static_cast<float>(line)) * turned.y + focal_px * turned.z;
      if (ray.z() < 0.05f * focal_px) continue;
      const Pixel pixel = parts.camera->pixel_of(
          NormalisedPoint{static_cast<double>(ray.x()) / ray.z(), static_cast<double>(ray.y()) / ray.z()});
      const int u = static_cast<int>(std::lround(pixel.u_px)), v = static_cast<int>(std::lround(pixel.v_px));
      if (u < 0 || v < 0 || u >= parts.width || v >= parts.height) continue;
      const std::size_t at =
          (static_cast<std::size_t>(line / kTreeWidth) * table.steps + (table.steps - 1 - step)) * kTreeWidth +
          line % kTreeWidth;
      table.pixel[at] = v * parts.stride + u;
      table.block[at] = blocks_about(parts, u, v);
      table.shift_m[at] = focal_px * baseline_m / turned.z.dot(parts.ray_of(u, v));
      float& edge = table.edge[static_cast<std::size_t>(line)];
      if (edge == 1e9f) edge = focal_px * baseline_m / kNearestBeyondEdge_m - static_cast<float>(step + 1);
    }
  return table;
}

}  // namespace adit::sim
