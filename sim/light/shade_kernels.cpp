// The shading loops. CMake compiles this file once per CPU target, with ADIT_SHADE_TARGET naming it.
#include "facet_noise.hpp"
#include "lane_vectors.hpp"
#include "lanes.hpp"
#include "sensor_rows.hpp"
#include "tile.hpp"
#include "triangle_lanes.hpp"

#define ADIT_TEXT_(x) #x
#define ADIT_TEXT(x) ADIT_TEXT_(x)
#define ADIT_JOIN_(a, b) a##b
#define ADIT_JOIN(a, b) ADIT_JOIN_(a, b)

namespace adit::sim {
namespace {

constexpr float kPi = 3.14159265f;
constexpr int kPacketLanes = kBlock * kBlock;
// Lanes do not touch each other's memory.
#define ADIT_LANES _Pragma("GCC ivdep")

void aim(Tile& t, const RowPose* rows, const float* const directions[3], int stride) {
  for (int v = 0; v < kTileHeight; ++v) {
    float r[9], place[3];
    for (int k = 0; k < 9; ++k) r[k] = rows[v].rotation[k];
    for (int k = 0; k < 3; ++k) place[k] = rows[v].place[k];
    const float* const dx = directions[0] + v * stride;
    const float* const dy = directions[1] + v * stride;
    const float* const dz = directions[2] + v * stride;
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float x = dx[u], y = dy[u], z = dz[u];
      t.dx[i] = r[0] * x + r[1] * y + r[2] * z;
      t.dy[i] = r[3] * x + r[4] * y + r[5] * z;
      t.dz[i] = r[6] * x + r[7] * y + r[8] * z;
      t.ox[i] = place[0];
      t.oy[i] = place[1];
      t.oz[i] = place[2];
    }
  }
}

/// Place, interpolated normal, geometric normal turned to the eye, material. Albedo, gloss and slope of facets run from
/// corner to corner too, so that wet and dry do not meet along triangles.
void geometry(Tile& t, const SurfaceTerms& terms, int first) {
  RowLanes near, far;
  take_rows(terms.triangles, t.triangle + first, 0, near);
  take_rows(terms.triangles, t.triangle + first, kTreeWidth, far);
  const auto& f = near.field;
  const auto& g = far.field;
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const int i = first + j;
    const float range = clamped(t.range[i], 0.0f, 1e5f);  // where nothing is hit, places still fit integers
    t.px[i] = t.ox[i] + t.dx[i] * range;
    t.py[i] = t.oy[i] + t.dy[i] * range;
    t.pz[i] = t.oz[i] + t.dz[i] * range;
    float gx = f[9][j], gy = f[10][j], gz = f[11][j];
    const float side = gx * t.dx[i] + gy * t.dy[i] + gz * t.dz[i] > 0.0f ? -1.0f : 1.0f;
    const float n_g = side / std::sqrt(gx * gx + gy * gy + gz * gz + 1e-30f);
    t.gx[i] = gx *= n_g;
    t.gy[i] = gy *= n_g;
    t.gz[i] = gz *= n_g;
    const float b = t.bu[i], c = t.bv[i], a = 1.0f - b - c;
    const float nx = a * f[12][j] + b * f[15][j] + c * g[2][j];
    const float ny = a * f[13][j] + b * g[0][j] + c * g[3][j];
    const float nz = a * f[14][j] + b * g[1][j] + c * g[4][j];
    // On the side of the geometric normal, whatever the winding.
    const float turn = nx * gx + ny * gy + nz * gz < 0.0f ? -1.0f : 1.0f;
    const float n = turn / std::sqrt(nx * nx + ny * ny + nz * nz + 1e-30f);
    t.nx[i] = nx * n;
    t.ny[i] = ny * n;
    t.nz[i] = nz * n;
    t.albedo[i] = a * g[5][j] + b * g[8][j] + c * g[11][j];
    t.specular[i] = a * g[6][j] + b * g[9][j] + c * g[12][j];
    t.slope[i] = a * g[7][j] + b * g[10][j] + c * g[13][j];
    t.material[i] = float_to_bits(g[14][j]);
  }
}

void reflectance(Tile& t, const MaterialTable& m) {
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const std::int32_t k = t.material[i];
    t.red[i] = m.red[k];
    t.blue[i] = m.blue[k];
    t.shininess[i] = m.shininess[k];
    t.emission[i] = m.emission[k];
  }
}

/// Sums over the sizes of facets: gradient and height of the noise.
struct alignas(64) FacetSums {
  Tile::Lane size_1_m, gx, gy, gz, height;
};

/// One size of facets. Those smaller than some two pixels melt away; their tilt is then the Lambert surface's own
/// roughness. A grazing view stretches the pixel on the ground; its two sides' geometric mean (footprint) decides.
/// Where they melt in the whole tile, the noise is not drawn at all.
void add_facets(const Tile& t, const Tile::Lane& footprint, FacetSums& into, const Lattice& lattice, float factor,
                float weight, std::uint32_t seed) {
  int seen_lanes = 0;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i)
    seen_lanes |= ((footprint[i] * (into.size_1_m[i] * factor) < 1.0f) & (t.slope[i] > 0.0f)) ? 1 : 0;
  if (seen_lanes == 0) return;
  const Lattice l = lattice;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const float scale = into.size_1_m[i] * factor;
    const float seen = weight * clamped(2.0f - 2.0f * footprint[i] * scale, 0.0f, 1.0f);
    const FacetSample f = facet_noise(t.px[i] * scale, t.py[i] * scale, t.pz[i] * scale, l, seed);
    into.gx[i] += seen * f.gx;
    into.gy[i] += seen * f.gy;
    into.gz[i] += seen * f.gz;
    into.height[i] += seen * f.value;
  }
}

/// FacetSums tilt the normal; patches, stains and wetness change the reflectance.
void roughen(Tile& t, const SurfaceTerms& terms) {
  const SurfaceTerms s = terms;
  const MaterialTable& m = *s.materials;
  static thread_local FacetSums facets;
  alignas(64) Tile::Lane footprint;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const float facing = clamped(-(t.gx[i] * t.dx[i] + t.gy[i] * t.dy[i] + t.gz[i] * t.dz[i]), 0.04f, 1.0f);
    footprint[i] = t.range[i] * s.pixel_angle * 2.0f / std::sqrt(facing);
    facets.size_1_m[i] = m.facet_1_m[t.material[i]];
    facets.gx[i] = facets.gy[i] = facets.gz[i] = facets.height[i] = 0.0f;
  }
  add_facets(t, footprint, facets, kLattices[0], 1.0f, 0.30f, 0x9e3779b9u);
  add_facets(t, footprint, facets, kLattices[1], 2.9f, 0.22f, 0x3c6ef372u);
  add_facets(t, footprint, facets, kLattices[2], 8.4f, 0.14f, 0xdaa66d2bu);
  add_facets(t, footprint, facets, kLattices[3], 24.4f, 0.09f, 0x78dde6e4u);
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const std::int32_t k = t.material[i];
    const float slope = t.slope[i];
    const float gx = facets.gx[i], gy = facets.gy[i], gz = facets.gz[i], height = facets.height[i];
    float nx = t.nx[i], ny = t.ny[i], nz = t.nz[i];
    const float along = gx * nx + gy * ny + gz * nz;
    nx -= slope * (gx - along * nx);
    ny -= slope * (gy - along * ny);
    nz -= slope * (gz - along * nz);
    const float n = 1.0f / std::sqrt(nx * nx + ny * ny + nz * nz + 1e-30f);
    t.nx[i] = nx * n;
    t.ny[i] = ny * n;
    t.nz[i] = nz * n;

    const float p = m.patch_1_m[k];
    const FacetSample broad = facet_noise(t.px[i] * p, t.py[i] * p, t.pz[i] * p, kLattices[2], 0x51ed270bu);
    const float q = p * 4.3f;
    const FacetSample fine = facet_noise(t.px[i] * q, t.py[i] * q, t.pz[i] * q, kLattices[1], 0x2545f491u);
    const float sigma = m.sigma[k];
    // 2.2 and 1.6 make the sum's standard deviation about one.
    const float log_albedo = sigma * (2.2f * broad.value + 1.6f * fine.value) - 0.5f * sigma * sigma;
    const float hollow = 1.0f + 0.35f * slope * height;  // dirt and shade in the hollows
    const float wet = clamped((broad.value + 0.5f * fine.value) * 4.0f + 0.6f, 0.0f, 1.0f);
    const float has_wet = t.specular[i] > 0.0f ? wet : 0.0f;
    t.specular[i] *= wet;
    t.albedo[i] = clamped(t.albedo[i] * exp_lane(log_albedo) * hollow * (1.0f - 0.4f * has_wet), 0.005f, 0.95f);
    // Stains: iron's brown to grey, along the same patches; hardly ever towards blue.
    const float stain = clamped(sigma * (0.45f * fine.value - 0.30f * broad.value), -0.05f, 0.5f);
    t.red[i] *= 1.0f + stain;
    t.blue[i] *= 1.0f - 1.3f * stain;
  }
}

void surface(Tile& t, const SurfaceTerms& s) {
  for (int i = 0; i < kTileLanes; i += kTreeWidth) geometry(t, s, i);
  reflectance(t, *s.materials);
  if (s.facets) roughen(t, s);
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i)
    t.own[i] = t.own_specular[i] = t.foreign[i] = t.foreign_specular[i] = t.sky[i] = 0.0f;
  std::memset(t.soft, 0, sizeof t.soft);
}

/// Irradiance (inverse square, Lambert's cosine) and specular luminance of one lamp, not yet shadowed.
void lamp(Tile& t, const LampTerms& terms) {
  const LampTerms l = terms;
  constexpr float kSteps = 512.0f;
  for (int v = 0; v < kTileHeight; ++v) {
    const float* place = l.places + v * l.row_stride;
    const float* axis = l.axes + v * l.row_stride;
    const float qx = place[0], qy = place[1], qz = place[2], ax = axis[0], ay = axis[1], az = axis[2];
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float lx = qx - t.px[i], ly = qy - t.py[i], lz = qz - t.pz[i];
      const float d2 = lx * lx + ly * ly + lz * lz + l.radius2_m2;
      const float inverse = 1.0f / std::sqrt(d2 + 1e-12f);
      const float wx = lx * inverse, wy = ly * inverse, wz = lz * inverse;
      const float cosine = -(wx * ax + wy * ay + wz * az);
      const float step = std::sqrt(clamped(0.5f - 0.5f * cosine, 0.0f, 1.0f)) * kSteps;
      const auto k = static_cast<std::int32_t>(step);
      const float f = step - static_cast<float>(k);
      const float lobe = l.lobe[k] + f * (l.lobe[k + 1] - l.lobe[k]);
      const float incidence = wx * t.nx[i] + wy * t.ny[i] + wz * t.nz[i];
      const float before = wx * t.gx[i] + wy * t.gy[i] + wz * t.gz[i];
      const float lit = ((incidence > 0.0f) & (before > 0.0f) & (t.triangle[i] >= 0)) ? 1.0f : 0.0f;
      const float e =
          lit * l.intensity_cd * lobe * inverse * inverse * incidence * exp_lane(-l.extinction_1_m * d2 * inverse);
      // Blinn and Phong's lobe, normalised.
      const float hx = wx - t.dx[i], hy = wy - t.dy[i], hz = wz - t.dz[i];
      const float h = 1.0f / std::sqrt(hx * hx + hy * hy + hz * hz + 1e-12f);
      const float gloss = clamped((hx * t.nx[i] + hy * t.ny[i] + hz * t.nz[i]) * h, 1e-6f, 1.0f);
      const float s = t.shininess[i];
      const float peak = t.specular[i] * (s + 8.0f) * (0.125f / kPi) * exp2_lane(s * log2_lane(gloss));
      t.share[i] = e;
      t.share_specular[i] = e * peak;
    }
  }
}

/// Points of light on quads of pixels: soft light changes little from pixel to pixel, but the normal does, and so it is
/// a vector that is summed. One pixel of each quad stands for all.
void virtual_lights(Tile& t, const VirtualLight* lights, int count, float clamp_m2, float extinction_1_m) {
  constexpr int kAcross = kTileWidth / 2;
  alignas(64) float px[Tile::kQuads], py[Tile::kQuads], pz[Tile::kQuads];
  alignas(64) float gx[Tile::kQuads], gy[Tile::kQuads], gz[Tile::kQuads];
  for (int v = 0; v < kTileHeight / 2; ++v)
    for (int u = 0; u < kAcross; ++u) {
      const int q = v * kAcross + u, i = 2 * v * kTileWidth + 2 * u;
      px[q] = t.px[i], py[q] = t.py[i], pz[q] = t.pz[i];
      gx[q] = t.gx[i], gy[q] = t.gy[i], gz[q] = t.gz[i];
    }
  for (int j = 0; j < count; ++j) {
    const VirtualLight l = lights[j];
    float *const sx = t.soft[l.colour][0], *const sy = t.soft[l.colour][1], *const sz = t.soft[l.colour][2];
    ADIT_LANES
    for (int q = 0; q < Tile::kQuads; ++q) {
      const float x = l.place[0] - px[q], y = l.place[1] - py[q], z = l.place[2] - pz[q];
      const float d2 = x * x + y * y + z * z;
      const float here = x * gx[q] + y * gy[q] + z * gz[q];
      const float there = -(x * l.normal[0] + y * l.normal[1] + z * l.normal[2]);
      const float soft = d2 + clamp_m2;
      // Attenuation to second order of exp(-x) = 1 / (1 + x + x^2 / 2 + ...): soft light need not be exact.
      const float x1 = extinction_1_m * std::sqrt(d2);
      const float power = ((here > 0.0f) & (there > 0.0f)) ? l.power * there : 0.0f;
      const float e = power / (soft * soft * (1.0f + x1 + 0.5f * x1 * x1));
      sx[q] += e * x;
      sy[q] += e * y;
      sz[q] += e * z;
    }
  }
}

void soft_light(Tile& t, bool own, bool foreign, bool sky) {
  const bool wanted[3] = {own, foreign, sky};
  float* const into[3] = {t.own, t.foreign, t.sky};
  for (int colour = 0; colour < 3; ++colour) {
    if (!wanted[colour]) continue;
    float* const lux = into[colour];
    for (int v = 0; v < kTileHeight; ++v) {
      const float* const sx = t.soft[colour][0] + v / 2 * (kTileWidth / 2);
      const float* const sy = t.soft[colour][1] + v / 2 * (kTileWidth / 2);
      const float* const sz = t.soft[colour][2] + v / 2 * (kTileWidth / 2);
      ADIT_LANES
      for (int u = 0; u < kTileWidth; ++u) {
        const int i = v * kTileWidth + u;
        const float e = sx[u / 2] * t.nx[i] + sy[u / 2] * t.ny[i] + sz[u / 2] * t.nz[i];
        lux[i] += e > 0.0f ? e : 0.0f;
      }
    }
  }
}

void mean_of_shifts(const float* const* rows, int taps, float share, float* out) {
  float sum[kBlurRun_px] = {};
  for (int k = 0; k < taps; ++k) {
    const float* const row = rows[k];
    for (int i = 0; i < kBlurRun_px; ++i) sum[i] += row[i];
  }
  for (int i = 0; i < kBlurRun_px; ++i) out[i] = sum[i] * share;
}

/// Backscatter by bilinear look-up over the image and linear over r / (r + scale).
ADIT_LANE float backscatter_at(const float* table, float range, float x, float y) {
  constexpr int kStrideX = BackscatterTable::kBins + 1;
  constexpr int kStrideY = BackscatterTable::kNodesX * kStrideX;
  const float bin = range / (range + BackscatterTable::kRangeScale_m) * (BackscatterTable::kBins - 0.001f);
  const auto k = static_cast<std::int32_t>(bin);
  const auto ix = static_cast<std::int32_t>(x), iy = static_cast<std::int32_t>(y);
  const float fk = bin - static_cast<float>(k), fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
  const std::int32_t at = iy * kStrideY + ix * kStrideX + k;
  const float a = table[at] + fk * (table[at + 1] - table[at]);
  const float b = table[at + kStrideX] + fk * (table[at + kStrideX + 1] - table[at + kStrideX]);
  const float c = table[at + kStrideY] + fk * (table[at + kStrideY + 1] - table[at + kStrideY]);
  const std::int32_t to = at + kStrideY + kStrideX;
  const float d = table[to] + fk * (table[to + 1] - table[to]);
  const float top = a + fx * (b - a), bottom = c + fx * (d - c);
  return top + fy * (bottom - top);
}

void compose(Tile& t, const ComposeTerms& terms, float* const planes[3], int stride) {
  const ComposeTerms c = terms;
  for (int v = 0; v < kTileHeight; ++v) {
    float* const red = planes[0] + v * stride;
    float* const green = planes[1] + v * stride;
    float* const blue = planes[2] + v * stride;
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float diffuse = t.albedo[i] * (1.0f / kPi);
      const float own = t.own[i], foreign = t.foreign[i], sky = t.sky[i];
      const float r = diffuse * t.red[i] * (own * c.own_red + foreign * c.foreign_red + sky * c.sky_red) +
                      t.own_specular[i] * c.own_red + t.foreign_specular[i] * c.foreign_red + t.emission[i];
      const float g = diffuse * (own + foreign + sky) + t.own_specular[i] + t.foreign_specular[i] + t.emission[i];
      const float b = diffuse * t.blue[i] * (own * c.own_blue + foreign * c.foreign_blue + sky * c.sky_blue) +
                      t.own_specular[i] * c.own_blue + t.foreign_specular[i] * c.foreign_blue + t.emission[i];
      const float hit = t.triangle[i] >= 0 ? 1.0f : 0.0f;
      const float through = hit * exp_lane(-c.extinction_1_m * t.range[i]);
      const float sky_seen = (1.0f - hit) * c.sky_luminance;
      red[u] = r * through + sky_seen * c.sky_red;
      green[u] = g * through + sky_seen;
      blue[u] = b * through + sky_seen * c.sky_blue;
    }
  }
  if (c.backscatter == nullptr) return;
  const float* table = &c.backscatter->luminance[0][0][0];
  for (int v = 0; v < kTileHeight; ++v) {
    const float y = static_cast<float>(c.v0 + v) * c.node_v;
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const float x = static_cast<float>(c.u0 + u) * c.node_u;
      const float haze = backscatter_at(table, t.range[v * kTileWidth + u], x, y);
      planes[0][v * stride + u] += haze * c.own_red;
      planes[1][v * stride + u] += haze;
      planes[2][v * stride + u] += haze * c.own_blue;
    }
  }
}

#include "parallax.inl"
#include "sensor_rows.inl"
#include "sight.inl"

}  // namespace

extern const ShadeKernels ADIT_JOIN(kShade_, ADIT_SHADE_TARGET);
const ShadeKernels ADIT_JOIN(kShade_, ADIT_SHADE_TARGET) = {ADIT_TEXT(ADIT_SHADE_TARGET),
                                                            aim,
                                                            see,
                                                            surface,
                                                            lamp,
                                                            virtual_lights,
                                                            soft_light,
                                                            mean_of_shifts,
                                                            compose,
                                                            parallax,
                                                            mosaic_row,
                                                            tone_row};

}  // namespace adit::sim
