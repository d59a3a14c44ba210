// From pose to linear light: rays, surfaces, lamps with shadows, indirect light, dust. Tiles know nothing of each
// other, so the frame does not depend on who computes which.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
constexpr std::uint32_t kAllBlocks = (1u << kBlocks) - 1u;

void fill_row_poses(Renderer::Parts& parts, const CameraMotion& motion, float readout_s) {
  parts.row_poses.resize(static_cast<std::size_t>(parts.rows));
  for (int v = 0; v < parts.rows; ++v) {
    const float t =
        readout_s *
        (static_cast<float>(std::min(v, parts.height - 1)) / static_cast<float>(std::max(parts.height - 1, 1)) - 0.5f);
    const Vector3f turn = motion.turn_rate_rad_s * t;
    Eigen::Matrix3f rotation = motion.pose.linear();
    if (turn.norm() > 1e-9f) rotation = rotation * Eigen::AngleAxisf(turn.norm(), turn.normalized()).toRotationMatrix();
    const Vector3f place = motion.pose.translation() + motion.pose.linear() * motion.velocity_m_s * t;
    RowPose& row = parts.row_poses[static_cast<std::size_t>(v)];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) row.rotation[3 * i + j] = rotation(i, j);
      row.place[i] = place[i];
    }
    for (std::size_t l = 0; l < parts.own_lamps.size(); ++l) {
      const Vector3f p = place + rotation * parts.own_lamps[l].place, a = rotation * parts.own_lamps[l].axis;
      for (int i = 0; i < 3; ++i) {
        row.lamp_place[l][i] = p[i];
        row.lamp_axis[l][i] = a[i];
      }
    }
  }
}

struct Bounds {
  Vector3f low = Vector3f::Constant(1e30f), high = Vector3f::Constant(-1e30f);
  [[nodiscard]] float distance2_to(const float* p) const {
    float sum = 0.0f;
    for (int k = 0; k < 3; ++k) {
      const float d = std::max({low[k] - p[k], 0.0f, p[k] - high[k]});
      sum += d * d;
    }
    return sum;
  }
};

Bounds bounds_of(const Tile& t) {
  Bounds b;
  for (int i = 0; i < kTileLanes; ++i) {
    if (t.triangle[i] < 0) continue;
    const Vector3f p(t.px[i], t.py[i], t.pz[i]);
    b.low = b.low.cwiseMin(p);
    b.high = b.high.cwiseMax(p);
  }
  return b;
}

/// Blocks of a tile that are marked in the frame, a bit each.
std::uint32_t marked_in(const std::vector<std::uint8_t>& blocks, const Renderer::Parts& parts, int u0, int v0) {
  constexpr int kAcross = kTileWidth / kBlock;
  std::uint32_t bits = 0;
  for (int b = 0; b < kBlocks; ++b) {
    const int u = u0 / kBlock + b % kAcross, v = v0 / kBlock + b / kAcross;
    bits |= static_cast<std::uint32_t>(blocks[static_cast<std::size_t>(v) * (parts.stride / kBlock) + u]) << b;
  }
  return bits;
}

void add_own_lamps(Tile& t, const Renderer::Parts& parts, const RowPose* rows, int u0, int v0, float least_lux) {
  for (std::size_t l = 0; l < parts.own_lamps.size(); ++l) {
    const OwnLamp& lamp = parts.own_lamps[l];
    const LampTerms terms{rows[0].lamp_place[l],
                          rows[0].lamp_axis[l],
                          sizeof(RowPose) / sizeof(float),
                          lamp.lobe.table(),
                          lamp.intensity_cd,
                          0.0f,
                          parts.rig.dust.extinction_1_m};
    shade_kernels().lamp(t, terms);
    add_unshadowed(t, parts, terms, least_lux,
                   parts.render.shadows ? marked_in(parts.dark_blocks[l], parts, u0, v0) : kAllBlocks, t.own,
                   t.own_specular);
  }
}

void add_foreign_lamps(Tile& t, const Renderer::Parts& parts, float least_lux) {
  if (parts.foreign_lamps.empty()) return;
  const Bounds bounds = bounds_of(t);
  const float sigma = parts.rig.dust.extinction_1_m;
  for (const ForeignLamp& lamp : parts.foreign_lamps) {
    const float radius2 = lamp.radius_m * lamp.radius_m;
    const float d2 = bounds.distance2_to(lamp.place.data()) + radius2;
    if (lamp.intensity_cd * std::exp(-sigma * std::sqrt(d2)) < least_lux * d2) continue;
    const LampTerms terms{lamp.place.data(), lamp.axis.data(), 0, lamp.lobe.table(), lamp.intensity_cd, radius2, sigma};
    shade_kernels().lamp(t, terms);
    add_unshadowed(t, parts, terms, least_lux, kAllBlocks, lamp.daylight ? t.sky : t.foreign, t.foreign_specular);
  }
  const float clamp2 = parts.render.indirect_clamp_m * parts.render.indirect_clamp_m;
  for (const VirtualLight& light : parts.foreign_bounces)
    if (light.power > least_lux * (bounds.distance2_to(light.place) + clamp2))
      shade_kernels().virtual_lights(t, &light, 1, clamp2, sigma);
}

/// The open sky over rock that lies outside: a ray straight up decides.
void add_zenith(Tile& t, const Renderer::Parts& parts) {
  constexpr float kReach_m = 40.0f;
  const float lux = parts.world->sky_lux;
  if (lux <= 0.0f) return;
  if (!parts.mouths.empty()) {
    const Bounds bounds = bounds_of(t);
    if (std::none_of(parts.mouths.begin(), parts.mouths.end(),
                     [&](const Vector3f& m) { return bounds.distance2_to(m.data()) < kReach_m * kReach_m; }))
      return;
  }
  RayPacket rays;
  for (int i = 0; i < kTileLanes; i += kPacket) {
    for (int j = 0; j < kPacket; ++j) {
      rays.origin[0][j] = t.px[i + j] + 0.01f * t.gx[i + j];
      rays.origin[1][j] = t.py[i + j] + 0.01f * t.gy[i + j];
      rays.origin[2][j] = t.pz[i + j] + 0.01f * t.gz[i + j];
      rays.direction[0][j] = rays.direction[1][j] = 0.0f;
      rays.direction[2][j] = 1.0f;
      rays.tnear[j] = 0.0f;
      rays.tfar[j] = t.triangle[i + j] >= 0 && t.gz[i + j] > -0.2f ? 1e4f : -1.0f;
    }
    const std::uint32_t dark = parts.scene->occluded(rays);
    for (int j = 0; j < kPacket; ++j)
      if (rays.tfar[j] > 0.0f && !(dark >> j & 1u)) t.sky[i + j] += lux * (0.5f + 0.5f * t.nz[i + j]);
  }
}

/// Where a tile stands in the frame.
struct TilePlace {
  int u0, v0, index;
  std::size_t at;  ///< of its first pixel
  TilePlace(const Renderer::Parts& parts, int tile) : index(tile) {
    const int across = parts.stride / kTileWidth;
    u0 = tile % across * kTileWidth;
    v0 = tile / across * kTileHeight;
    at = static_cast<std::size_t>(v0) * parts.stride + u0;
  }
};

void aim_tile(Tile& t, const Renderer::Parts& parts, const TilePlace& place) {
  shade_kernels().aim(t, &parts.row_poses[static_cast<std::size_t>(place.v0)],
                      &parts.directions[static_cast<std::size_t>(place.index) * 3 * kTileLanes]);
}

void see_tile(Renderer::Parts& parts, int tile) {
  static thread_local Tile t;
  const TilePlace place(parts, tile);
  aim_tile(t, parts, place);
  static_assert(kNoRange_m == kRangeOfNothing_m);
  const RowPose& middle = parts.row_poses[static_cast<std::size_t>(place.v0 + kTileHeight / 2)];
  shade_kernels().see(t, middle.rotation, parts.tree.nodes.data(), parts.tree.leaves.data(), parts.triangles.data());
  parts.hits[static_cast<std::size_t>(tile)] = t;
  for (int v = 0; v < kTileHeight; ++v)
    std::copy_n(&t.range[v * kTileWidth], kTileWidth,
                &parts.range[place.at + static_cast<std::size_t>(v) * parts.stride]);
}

/// Blocks that the own lamps may leave dark, from what all tiles see.
void watch_own_lamps(Renderer::Parts& parts) {
  const std::size_t blocks = static_cast<std::size_t>(parts.stride / kBlock) * (parts.rows / kBlock);
  parts.dark_blocks.resize(parts.own_lamps.size());
  for (std::size_t l = 0; l < parts.own_lamps.size(); ++l) {
    const ParallaxTable& table = parts.own_lamps[l].parallax;
    parts.dark_blocks[l].assign(blocks, table.lines == 0 ? 1 : 0);
    parts.each(table.lines / kTreeWidth, [&](int i) {
      shade_kernels().parallax(table, i * kTreeWidth, parts.range.data(), parts.stride / kBlock,
                               parts.dark_blocks[l].data());
    });
  }
}

/// The table of triangles lies far from the core; while rays are aimed its rows are on their way.
void send_for_triangles(const Tile& t, const Renderer::Parts& parts) {
  const TriangleRow* const rows = parts.triangles.data();
  for (const std::int32_t triangle : t.triangle) {
    const float* const row = rows[triangle < 0 ? 0 : triangle].corner;
    __builtin_prefetch(row);
    __builtin_prefetch(row + kRowFloats / 2);
  }
}

void light_tile(Renderer::Parts& parts, int tile, float least_lux) {
  static thread_local Tile t;
  const TilePlace place(parts, tile);
  const int u0 = place.u0, v0 = place.v0;
  const std::size_t at = place.at;
  const RowPose* const rows = &parts.row_poses[static_cast<std::size_t>(v0)];
  const ShadeKernels& kernels = shade_kernels();
  static_cast<TileHits&>(t) = parts.hits[static_cast<std::size_t>(tile)];
  send_for_triangles(t, parts);
  aim_tile(t, parts, place);
  kernels.surface(t, {&parts.materials, parts.triangles.data(), parts.pixel_angle, parts.render.facets});
  const RenderConfig& r = parts.render;
  if (t.any) {
    if (parts.lamps_on) add_own_lamps(t, parts, rows, u0, v0, least_lux);
    kernels.virtual_lights(t, parts.bounces.data(), static_cast<int>(parts.bounces.size()),
                           r.indirect_clamp_m * r.indirect_clamp_m, parts.rig.dust.extinction_1_m);
    add_foreign_lamps(t, parts, least_lux);
    kernels.soft_light(t, !parts.bounces.empty(), !parts.foreign_bounces.empty(), !parts.foreign_bounces.empty());
    add_zenith(t, parts);
  }
  const LampRig& lamps = parts.rig.lamps;
  constexpr float kSkyRed = 0.92f, kSkyBlue = 1.12f;  // a clear sky and sun together, about 6500 K
  const ComposeTerms terms{lamps.tint_red,
                           lamps.tint_blue,
                           r.foreign_red,
                           r.foreign_blue,
                           kSkyRed,
                           kSkyBlue,
                           parts.rig.dust.extinction_1_m,
                           parts.world->sky_lux / 3.14159265f,
                           parts.lamps_on ? parts.backscatter.get() : nullptr,
                           static_cast<float>(BackscatterTable::kNodesX - 1) / static_cast<float>(parts.stride),
                           static_cast<float>(BackscatterTable::kNodesY - 1) / static_cast<float>(parts.rows),
                           u0,
                           v0};
  float* const planes[3] = {&parts.planes[0][at], &parts.planes[1][at], &parts.planes[2][at]};
  kernels.compose(t, terms, planes, parts.stride);
}

}  // namespace

void light_pass(Renderer::Parts& parts, const CameraMotion& motion, float readout_s) {
  fill_row_poses(parts, motion, readout_s);
  parts.bounces.clear();
  const int lamp_count = static_cast<int>(parts.own_lamps.size());
  for (const OwnLamp& lamp : parts.own_lamps) {
    Eigen::Isometry3f in_camera = Eigen::Isometry3f::Identity();
    in_camera.translate(lamp.place);
    in_camera.rotate(Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitZ(), lamp.axis));
    const int count = parts.render.virtual_lights / std::max(lamp_count, 1);
    if (count > 0 && parts.lamps_on)
      add_bounces(parts.bounces, *parts.world, *parts.scene, motion.pose * in_camera, lamp.lobe, lamp.intensity_cd,
                  count, parts.rig.dust.extinction_1_m, 0);
  }
  const float least_lux = parts.render.cull_fraction * motion.white_luminance * 3.14159265f;
  const int tiles = parts.stride / kTileWidth * (parts.rows / kTileHeight);
  parts.hits.resize(static_cast<std::size_t>(tiles));
  parts.each(tiles, [&](int i) { see_tile(parts, i); });
  if (parts.render.shadows && parts.lamps_on) watch_own_lamps(parts);
  parts.each(tiles, [&](int i) { light_tile(parts, i, least_lux); });
}

}  // namespace adit::sim
