// What each pixel sees. Packets of 4 x 4 pixels: a square of rays stays together longest in the tree.
#include <cmath>

#include "parts.hpp"

namespace adit::sim {
namespace {

/// Along a plane 1 / range runs nearly straight through the image, however steep the view: a place that lies off the
/// plane through the corners of its block tells of an edge.
bool is_even(const float* range) {
  constexpr float kShare = 0.03f;
  float inverse[kPacket];
  for (int j = 0; j < kPacket; ++j) inverse[j] = 1.0f / range[j];
  constexpr int kLast = kBlock - 1;
  constexpr float kThird = 1.0f / kLast;
  int off = 0;
  for (int v = 0; v < kBlock; ++v) {
    const float y = kThird * static_cast<float>(v);
    const float left = inverse[0] + y * (inverse[kLast * kBlock] - inverse[0]);
    const float right = inverse[kLast] + y * (inverse[kPacket - 1] - inverse[kLast]);
    for (int u = 0; u < kBlock; ++u) {
      const float here = inverse[v * kBlock + u];
      const float expected = left + kThird * static_cast<float>(u) * (right - left);
      off |= std::abs(here - expected) > kShare * here ? 1 : 0;
    }
  }
  return off == 0;
}

}  // namespace

bool trace_tile(Tile& t, const RayScene& scene) {
  constexpr float kNear_m = 0.02f;
  RayPacket rays;
  HitPacket hits;
  bool any = false;
  t.even_blocks = 0;
  for (int j = 0; j < kPacket; ++j) {
    rays.tnear[j] = kNear_m;
    rays.tfar[j] = kRangeOfNothing_m;
  }
  for (int b = 0; b < kBlocks; ++b) {
    const int first = kBlockLanes[static_cast<std::size_t>(b)];
    for (int j = 0; j < kPacket; j += kBlock)
      for (int k = 0; k < kBlock; ++k) {
        const int i = first + j / kBlock * kTileWidth + k;
        rays.origin[0][j + k] = t.ox[i];
        rays.origin[1][j + k] = t.oy[i];
        rays.origin[2][j + k] = t.oz[i];
        rays.direction[0][j + k] = t.dx[i];
        rays.direction[1][j + k] = t.dy[i];
        rays.direction[2][j + k] = t.dz[i];
      }
    scene.intersect(rays, hits);
    t.even_blocks |= (is_even(hits.t) ? 1u : 0u) << b;
    for (int j = 0; j < kPacket; j += kBlock)
      for (int k = 0; k < kBlock; ++k) {
        const int i = first + j / kBlock * kTileWidth + k;
        const bool hit = hits.triangle[j + k] != kNoTriangle;
        any |= hit;
        t.range[i] = hit ? hits.t[j + k] : kRangeOfNothing_m;
        t.bu[i] = hit ? hits.u[j + k] : 0.0f;
        t.bv[i] = hit ? hits.v[j + k] : 0.0f;
        t.triangle[i] = hit ? static_cast<std::int32_t>(hits.triangle[j + k]) : -1;
      }
  }
  return any;
}

}  // namespace adit::sim
