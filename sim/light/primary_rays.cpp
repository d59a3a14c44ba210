// What each pixel sees, and where that goes on evenly.
#include <cmath>

#include "parts.hpp"

namespace adit::sim {
namespace {

/// Along a plane 1 / range runs nearly straight through the image, however steep the view: a place that lies off the
/// plane through the corners of its block tells of an edge.
bool is_even(const float* range) {
  constexpr float kShare = 0.03f;
  float inverse[kBlock * kBlock];
  for (int v = 0; v < kBlock; ++v)
    for (int u = 0; u < kBlock; ++u) inverse[v * kBlock + u] = 1.0f / range[v * kTileWidth + u];
  constexpr int kLast = kBlock - 1;
  constexpr float kThird = 1.0f / kLast;
  int off = 0;
  for (int v = 0; v < kBlock; ++v) {
    const float y = kThird * static_cast<float>(v);
    const float left = inverse[0] + y * (inverse[kLast * kBlock] - inverse[0]);
    const float right = inverse[kLast] + y * (inverse[kBlock * kBlock - 1] - inverse[kLast]);
    for (int u = 0; u < kBlock; ++u) {
      const float here = inverse[v * kBlock + u];
      const float expected = left + kThird * static_cast<float>(u) * (right - left);
      off |= std::abs(here - expected) > kShare * here ? 1 : 0;
    }
  }
  return off == 0;
}

}  // namespace

void trace_tile(Tile& t, const RowPose& middle, const Renderer::Parts& parts) {
  static_assert(kNoRange_m == kRangeOfNothing_m);
  t.any = shade_kernels().see(t, middle.rotation, parts.tree.nodes.data(), parts.tree.leaves.data(),
                              parts.triangles.data());
  t.even_blocks = 0;
  for (int b = 0; b < kBlocks; ++b)
    t.even_blocks |= (is_even(&t.range[kBlockLanes[static_cast<std::size_t>(b)]]) ? 1u : 0u) << b;
}

}  // namespace adit::sim
