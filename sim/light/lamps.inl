// What lamps and the points of light of the indirect light add to a tile. Included by shade_kernels.cpp.

/// LampLobe's table at these cosines to the axis.
ADIT_LANE Floats lobe_at(const float* table, const Floats& cosine) {
  constexpr float kSteps = 512.0f;
  const Floats share = lesser(greater(0.5f - 0.5f * cosine, Floats{}), all_of(1.0f));
  const Floats step = root_of(share) * kSteps;
  const Ints k = truncated(step);
  const Floats f = step - __builtin_convertvector(k, Floats);
  const FloatPairs lobe = pairs_from(table, k);
  return lobe.first + f * (lobe.second - lobe.first);
}

/// Irradiance (inverse square, Lambert's cosine) and specular luminance of one lamp, not yet shadowed; sixteen lanes.
void lamp_lanes(Tile& t, const LampTerms& l, const float* place, const float* axis, int first) {
  const Floats &nx = floats_at(t.nx + first), &ny = floats_at(t.ny + first), &nz = floats_at(t.nz + first);
  const Floats lx = place[0] - floats_at(t.px + first), ly = place[1] - floats_at(t.py + first),
               lz = place[2] - floats_at(t.pz + first);
  const Floats d2 = lx * lx + ly * ly + lz * lz + l.radius2_m2;
  const Floats inverse = 1.0f / root_of(d2 + 1e-12f);
  const Floats wx = lx * inverse, wy = ly * inverse, wz = lz * inverse;
  const Floats lobe = lobe_at(l.lobe, -(wx * axis[0] + wy * axis[1] + wz * axis[2]));
  const Floats incidence = wx * nx + wy * ny + wz * nz;
  const Floats before = wx * floats_at(t.gx + first) + wy * floats_at(t.gy + first) + wz * floats_at(t.gz + first);
  const Ints is_lit = (incidence > 0.0f) & (before > 0.0f) & (ints_at(t.triangle + first) >= 0);
  const Floats lit = is_lit ? all_of(1.0f) : Floats{};
  const Floats e =
      lit * l.intensity_cd * lobe * inverse * inverse * incidence * exp_lanes(-l.extinction_1_m * d2 * inverse);
  // Blinn and Phong's lobe, normalised.
  const Floats hx = wx - floats_at(t.dx + first), hy = wy - floats_at(t.dy + first), hz = wz - floats_at(t.dz + first);
  const Floats h = 1.0f / root_of(hx * hx + hy * hy + hz * hz + 1e-12f);
  const Floats gloss = lesser(greater((hx * nx + hy * ny + hz * nz) * h, all_of(1e-6f)), all_of(1.0f));
  const Floats& s = floats_at(t.shininess + first);
  const Floats peak = floats_at(t.specular + first) * (s + 8.0f) * (0.125f / kPi) * exp2_lanes(s * log2_lanes(gloss));
  floats_at(t.share + first) = e;
  floats_at(t.share_specular + first) = e * peak;
}

void lamp(Tile& t, const LampTerms& terms) {
  const LampTerms l = terms;
  for (int v = 0; v < kTileHeight; ++v)
    for (int u = 0; u < kTileWidth; u += kTreeWidth)
      lamp_lanes(t, l, l.places + v * l.row_stride, l.axes + v * l.row_stride, v * kTileWidth + u);
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
