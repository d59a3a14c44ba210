// Which places a lamp reaches. Rays go from the lamp to the rock: they have one origin, which keeps a packet together
// in the tree. Where the surface goes on evenly through a block of pixels and its corners agree, they speak for the
// rest.
#include "parts.hpp"

namespace adit::sim {
namespace {

constexpr int kAcross = kTileWidth / kBlock, kDown = kTileHeight / kBlock;
constexpr int kPointsAcross = kAcross + 1, kPoints = kPointsAcross * (kDown + 1);

/// Corners of blocks: every fourth pixel, and the last.
constexpr int lane_of_point(int point) {
  const int u = point % kPointsAcross * kBlock, v = point / kPointsAcross * kBlock;
  return (v < kTileHeight ? v : kTileHeight - 1) * kTileWidth + (u < kTileWidth ? u : kTileWidth - 1);
}

constexpr int first_point_of(int block) { return block / kAcross * kPointsAcross + block % kAcross; }

/// Puts the ray from the lamp to the surface at lane i into lane j of a packet.
void aim_from_lamp(const Tile& t, const LampTerms& lamp, int i, RayPacket& rays, int j) {
  const float* const place = lamp.places + i / kTileWidth * lamp.row_stride;
  // It ends off the surface, so that this does not shade itself.
  const float off = 2e-3f + 2e-4f * t.range[i];
  rays.origin[0][j] = place[0];
  rays.origin[1][j] = place[1];
  rays.origin[2][j] = place[2];
  rays.direction[0][j] = t.px[i] + off * t.gx[i] - place[0];
  rays.direction[1][j] = t.py[i] + off * t.gy[i] - place[1];
  rays.direction[2][j] = t.pz[i] + off * t.gz[i] - place[2];
  rays.tnear[j] = 1e-3f;
  rays.tfar[j] = t.triangle[i] >= 0 ? 1.0f : -1.0f;
}

/// Blocks where any share counts, a bit each.
std::uint32_t blocks_with(const Tile& t, float least_lux) {
  std::uint32_t wanted = 0;
  for (int b = 0; b < kBlocks; ++b) {
    int any = 0;
    for (int v = 0; v < kBlock; ++v)
      for (int u = 0; u < kBlock; ++u) {
        const int i = kBlockLanes[static_cast<std::size_t>(b)] + v * kTileWidth + u;
        any |= t.share[i] + t.share_specular[i] > least_lux ? 1 : 0;
      }
    wanted |= static_cast<std::uint32_t>(any) << b;
  }
  return wanted;
}

/// Whether the corners of the wanted blocks are dark, a bit a point.
std::uint32_t dark_points(const Tile& t, const RayScene& scene, const LampTerms& lamp, std::uint32_t wanted) {
  constexpr std::uint32_t kCorners = 1u | 1u << 1 | 1u << kPointsAcross | 1u << (kPointsAcross + 1);
  std::uint32_t asked = 0, dark = 0;
  for (int b = 0; b < kBlocks; ++b)
    if (wanted >> b & 1u) asked |= kCorners << first_point_of(b);
  RayPacket rays;
  int points[kPacket], count = 0;
  const auto ask = [&] {
    for (int j = count; j < kPacket; ++j) {
      aim_from_lamp(t, lamp, lane_of_point(points[0]), rays, j);
      rays.tfar[j] = -1.0f;
    }
    const std::uint32_t bits = scene.occluded(rays);
    for (int j = 0; j < count; ++j) dark |= (bits >> j & 1u) << points[j];
    count = 0;
  };
  for (int point = 0; point < kPoints; ++point) {
    if (!(asked >> point & 1u)) continue;
    aim_from_lamp(t, lamp, lane_of_point(point), rays, count);
    points[count++] = point;
    if (count == kPacket) ask();
  }
  if (count > 0) ask();
  return dark;
}

void set_block(float* lit, int block, std::uint32_t bits) {
  for (int k = 0; k < kBlock * kBlock; ++k)
    lit[kBlockLanes[static_cast<std::size_t>(block)] + k / kBlock * kTileWidth + k % kBlock] =
        bits >> k & 1u ? 1.0f : 0.0f;
}

}  // namespace

void add_unshadowed(Tile& t, const Renderer::Parts& parts, const LampTerms& lamp, float least_lux,
                    std::uint32_t doubtful, float* into, float* specular_into) {
  const std::uint32_t wanted = blocks_with(t, least_lux);
  if (wanted == 0) return;
  constexpr std::uint32_t kAll = 0xffffu;
  if (!parts.render.shadows) doubtful = 0;
  const std::uint32_t dark = (wanted & doubtful) != 0 ? dark_points(t, *parts.scene, lamp, wanted & doubtful) : 0;
  alignas(64) Tile::Lane lit;
  RayPacket rays;
  for (int b = 0; b < kBlocks; ++b) {
    std::uint32_t bits = 0;
    if (wanted >> b & 1u) {
      const std::uint32_t at = dark >> first_point_of(b);
      const std::uint32_t corners = (at & 3u) | (at >> kPointsAcross & 3u) << 2;
      if (!(doubtful >> b & 1u)) {
        bits = kAll;
      } else if (t.even_blocks >> b & 1u && (corners == 0 || corners == 0xfu)) {
        bits = corners == 0 ? kAll : 0;
      } else {
        for (int k = 0; k < kPacket; ++k)
          aim_from_lamp(t, lamp, kBlockLanes[static_cast<std::size_t>(b)] + k / kBlock * kTileWidth + k % kBlock, rays,
                        k);
        bits = ~parts.scene->occluded(rays) & kAll;
      }
    }
    set_block(lit, b, bits);
  }
  for (int i = 0; i < kTileLanes; ++i) {
    into[i] += lit[i] * t.share[i];
    specular_into[i] += lit[i] * t.share_specular[i];
  }
}

}  // namespace adit::sim
