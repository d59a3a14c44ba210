// What lamps and the points of light of the indirect light add to a tile. Included by shade_kernels.cpp.

/// Irradiance (inverse square, Lambert's cosine) and specular luminance of one lamp, not yet shadowed.
void lamp(Tile& t, const LampTerms& terms) {
  const LampTerms l = terms;
  constexpr float kSteps = 512.0f;
  const float *const lobe_here = l.lobe, *const lobe_next = l.lobe + 1;  // two bases: indices stay 32 bits wide
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
      const float lobe = lobe_here[k] + f * (lobe_next[k] - lobe_here[k]);
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
