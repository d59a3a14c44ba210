// What a tile of pixels is of: place, normal, facets, reflectance. Included by shade_kernels.cpp.

void aim(Tile& t, const RowPose* rows, const float* directions) {
  const float *const dx = directions, *const dy = dx + kTileLanes, *const dz = dy + kTileLanes;
  for (int v = 0; v < kTileHeight; ++v) {
    float r[9];
    for (int k = 0; k < 9; ++k) r[k] = rows[v].rotation[k];
    for (int k = 0; k < 3; ++k) t.origin[v][k] = rows[v].place[k];
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float x = dx[i], y = dy[i], z = dz[i];
      t.dx[i] = r[0] * x + r[1] * y + r[2] * z;
      t.dy[i] = r[3] * x + r[4] * y + r[5] * z;
      t.dz[i] = r[6] * x + r[7] * y + r[8] * z;
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
  const float* const origin = t.origin[first / kTileWidth];
  const float ox = origin[0], oy = origin[1], oz = origin[2];
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const int i = first + j;
    const float range = clamped(t.range[i], 0.0f, 1e5f);  // where nothing is hit, places still fit integers
    t.px[i] = ox + t.dx[i] * range;
    t.py[i] = oy + t.dy[i] * range;
    t.pz[i] = oz + t.dz[i] * range;
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
