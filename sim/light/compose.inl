// Light gathered by a tile -> what reaches the lens through the air. Included by shade_kernels.cpp.

/// Backscatter by bilinear look-up over the image and linear over r / (r + scale).
ADIT_LANE Floats backscatter_at(const float* table, const Floats& range, const Floats& x, float y) {
  constexpr int kStrideX = BackscatterTable::kBins + 1;
  constexpr int kStrideY = BackscatterTable::kNodesX * kStrideX;
  const Floats bin = range / (range + BackscatterTable::kRangeScale_m) * (BackscatterTable::kBins - 0.001f);
  const Ints k = truncated(bin), ix = truncated(x);
  const auto iy = static_cast<std::int32_t>(y);
  const Floats fk = bin - __builtin_convertvector(k, Floats), fx = x - __builtin_convertvector(ix, Floats);
  const float fy = y - static_cast<float>(iy);
  const Ints at = iy * kStrideY + ix * kStrideX + k;
  const auto in_range = [&](int offset) {
    const FloatPairs bins = pairs_from(table + offset, at);
    return Floats(bins.first + fk * (bins.second - bins.first));
  };
  const Floats a = in_range(0), b = in_range(kStrideX), c = in_range(kStrideY), d = in_range(kStrideY + kStrideX);
  const Floats top = a + fx * (b - a), bottom = c + fx * (d - c);
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
    for (int u = 0; u < kTileWidth; u += kTreeWidth) {
      const Floats x = __builtin_convertvector(lane_numbers() + (c.u0 + u), Floats) * c.node_u;
      const Floats haze = backscatter_at(table, floats_at(t.range + v * kTileWidth + u), x, y);
      const float tint[3] = {c.own_red, 1.0f, c.own_blue};
      for (int k = 0; k < 3; ++k) {
        float* const out = planes[k] + v * stride + u;
        const Floats sum = lanes_from<Floats>(out) + haze * tint[k];
        std::memcpy(out, &sum, sizeof sum);
      }
    }
  }
}
