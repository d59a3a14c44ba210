// The pyramid of rays of a tile: where its pixels lie in a grid of slopes, and what each has met so far. Included by
// sight.inl.

struct Way {
  float x, y, z;
};
ADIT_LANE float dot(const Way& a, const Way& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A tile's pyramid of rays, and what they have met.
struct alignas(64) Sight {
  // Rays and what they have met, block by block: 1 / range of the nearest so far, 0 for nothing.
  float dx[kTileLanes], dy[kTileLanes], dz[kTileLanes], nearest[kTileLanes];
  std::int32_t triangle[kTileLanes];
  float farthest[kBlocks];  ///< least of `nearest` in each block
  std::uint32_t drawn;      ///< blocks whose `farthest` waits to be brought up to date, a bit each
  Way origin;
  // The optical frame of the tile's middle row. All zero where the rays do not make a grid: then nothing is culled.
  Way right, down, forward;
  Way side[4];  ///< planes through the origin, the pyramid inside: p * n >= 0
  // In this frame a ray runs through (x, y, 1), and that of pixel (u, v) lies within (x_low, x_high) of x_first +
  // u * step; so that from an interval of x follows which columns it may hold.
  float x_first, x_low, x_high, columns_per_x;
  float y_first, y_low, y_high, rows_per_y;
};

/// Rounding: of places, m, up to a kilometre away, and of slopes x / z.
constexpr float kPlaceSlack_m = 2e-4f;
constexpr float kSlopeSlack = 1e-5f;
constexpr float kBeside_m = 0.01f;  ///< nearer to the lens's plane slopes are not used

ADIT_LANE Way scaled(const Way& a, float by) { return {a.x * by, a.y * by, a.z * by}; }
ADIT_LANE Way sum(const Way& a, const Way& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// Where a tile's rays run in its own frame: extremes over each column of pixels.
struct alignas(64) Slopes {
  float x[kTileLanes], y[kTileLanes];
  float x_low[kTileWidth], x_high[kTileWidth], y_low[kTileWidth], y_high[kTileWidth];
};

ADIT_LANE float lesser(float a, float b) { return a < b ? a : b; }
ADIT_LANE float greater(float a, float b) { return a > b ? a : b; }

/// @return whether all rays go forward.
bool slopes_of(const Tile& t, const Sight& s, Slopes& slopes) {
  const Way right = s.right, down = s.down, forward = s.forward;
  std::int32_t aside = 0;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const float z = t.dx[i] * forward.x + t.dy[i] * forward.y + t.dz[i] * forward.z;
    aside |= z > 0.05f ? 0 : 1;
    slopes.x[i] = (t.dx[i] * right.x + t.dy[i] * right.y + t.dz[i] * right.z) / z;
    slopes.y[i] = (t.dx[i] * down.x + t.dy[i] * down.y + t.dz[i] * down.z) / z;
  }
  return aside == 0;
}

/// The columns and rows of the grid, and how far its rays lie off them.
void fit_grid(Sight& s, Slopes& g) {
  constexpr int kMiddle = kTileHeight / 2 * kTileWidth + kTileWidth / 2;
  // The first step, not the mean: lanes beyond the image's edge repeat its last pixel.
  const float x_step = g.x[kMiddle - kTileWidth / 2 + 1] - g.x[kMiddle - kTileWidth / 2];
  const float y_step = g.y[kTileWidth + kTileWidth / 2] - g.y[kTileWidth / 2];
  s.x_first = g.x[kMiddle - kTileWidth / 2];
  s.y_first = g.y[kTileWidth / 2];
  for (int u = 0; u < kTileWidth; ++u) {
    g.x_low[u] = g.y_low[u] = 1e9f;
    g.x_high[u] = g.y_high[u] = -1e9f;
  }
  float x_least = 1e9f, x_most = -1e9f, y_least = 1e9f, y_most = -1e9f;
  for (int v = 0; v < kTileHeight; ++v) {
    const float y = s.y_first + static_cast<float>(v) * y_step;
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float x_off = g.x[i] - (s.x_first + static_cast<float>(u) * x_step), y_off = g.y[i] - y;
      g.x_low[u] = lesser(g.x_low[u], x_off);
      g.x_high[u] = greater(g.x_high[u], x_off);
      g.y_low[u] = lesser(g.y_low[u], y_off);
      g.y_high[u] = greater(g.y_high[u], y_off);
    }
  }
  s.x_low = s.y_low = 1e9f;
  s.x_high = s.y_high = -1e9f;
  for (int u = 0; u < kTileWidth; ++u) {
    const float x = s.x_first + static_cast<float>(u) * x_step;
    x_least = lesser(x_least, x + g.x_low[u]);
    x_most = greater(x_most, x + g.x_high[u]);
    s.x_low = lesser(s.x_low, g.x_low[u]);
    s.x_high = greater(s.x_high, g.x_high[u]);
    s.y_low = lesser(s.y_low, g.y_low[u]);
    s.y_high = greater(s.y_high, g.y_high[u]);
  }
  y_least = s.y_first + s.y_low;
  y_most = s.y_first + (kTileHeight - 1) * y_step + s.y_high;
  if (!(x_step > 1e-7f) || !(y_step > 1e-7f)) {
    s.right = s.down = s.forward = Way{0.0f, 0.0f, 0.0f};
    return;
  }
  s.columns_per_x = 1.0f / x_step;
  s.rows_per_y = 1.0f / y_step;
  s.side[0] = sum(s.right, scaled(s.forward, -(x_least - kSlopeSlack)));
  s.side[1] = sum(scaled(s.right, -1.0f), scaled(s.forward, x_most + kSlopeSlack));
  s.side[2] = sum(s.down, scaled(s.forward, -(y_least - kSlopeSlack)));
  s.side[3] = sum(scaled(s.down, -1.0f), scaled(s.forward, y_most + kSlopeSlack));
}

/// Lanes of a block, row by row.
ADIT_LANE Floats block_of(const float* lanes, int block) {
  return runs_from(lanes + kBlockLanes[static_cast<std::size_t>(block)], kTileWidth);
}

/// @param axes rotation from the optical frame to the world, row major: in this frame the rays of a lens that does not
/// bend lines make an even grid.
void aim_sight(const Tile& t, const float* axes, Sight& s) {
  for (int b = 0; b < kBlocks; ++b) {
    const int first = b * kPacketLanes;
    floats_at(s.dx + first) = block_of(t.dx, b);
    floats_at(s.dy + first) = block_of(t.dy, b);
    floats_at(s.dz + first) = block_of(t.dz, b);
    floats_at(s.nearest + first) = Floats{};
    ints_at(s.triangle + first) = Ints{} - 1;
    s.farthest[b] = 0.0f;
  }
  s.drawn = 0;
  const float* const origin = t.origin[kTileHeight / 2];
  s.origin = {origin[0], origin[1], origin[2]};
  s.right = {axes[0], axes[3], axes[6]};
  s.down = {axes[1], axes[4], axes[7]};
  s.forward = {axes[2], axes[5], axes[8]};
  for (Way& n : s.side) n = {0.0f, 0.0f, 0.0f};
  static thread_local Slopes slopes;
  if (slopes_of(t, s, slopes))
    fit_grid(s, slopes);
  else
    s.right = s.down = s.forward = Way{0.0f, 0.0f, 0.0f};
}
