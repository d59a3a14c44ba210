// How often each level stands in a plane, by comparing: for targets without a quick look-up of 16 bytes or count of
// bits.
//
// In a closed plane the values of a small tile lie close together: comparing the tile with each of them in turn is
// several times faster than counting pixel by pixel. Tiles of many values are counted by pixel, in four sets of
// counters, so that equal neighbours do not wait for each other.
constexpr int kTileSide = 16;
constexpr int kTileVectors = kTileSide * kTileSide / Bytes::kLanes;
constexpr int kTileLevelsMax = 48;

struct LevelCounters {
  std::uint32_t set[4][256];
};

inline void count_pixels(const std::uint8_t* tile, std::ptrdiff_t stride, LevelCounters& counters) {
  for (int v = 0; v < kTileSide; ++v) {
    for (int x = 0; x < kTileSide; x += 4) {
      std::uint32_t four;
      __builtin_memcpy(&four, tile + v * stride + x, sizeof four);
      ++counters.set[0][four & 255u];
      ++counters.set[1][(four >> 8) & 255u];
      ++counters.set[2][(four >> 16) & 255u];
      ++counters.set[3][four >> 24];
    }
  }
}

inline void count_tile(const std::uint8_t* tile, std::ptrdiff_t stride, LevelCounters& counters) {
  Bytes part[kTileVectors];
  for (int i = 0; i < kTileVectors; ++i) part[i] = load_16_wide(tile + i * (kTileSide / kTileVectors) * stride, stride);
  Bytes low = part[0];
  Bytes high = part[0];
  for (int i = 1; i < kTileVectors; ++i) {
    low = smallest(low, part[i]);
    high = largest(high, part[i]);
  }
  const int first = least(low);
  const int last = most(high);
  if (last - first >= kTileLevelsMax) return count_pixels(tile, stride, counters);
  std::uint32_t left = kTileSide * kTileSide;
  for (int level = first; level < last; ++level) {
    const std::uint32_t found = occurrences(part, static_cast<std::uint8_t>(level));
    counters.set[0][level] += found;
    left -= found;
  }
  counters.set[0][last] += left;
}

void count_levels(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height, std::uint32_t* totals) {
  LevelCounters counters;
  __builtin_memset(&counters, 0, sizeof counters);
  const int tiles_right = width - width % kTileSide;
  const int tiles_below = height - height % kTileSide;
  for (int v = 0; v < tiles_below; v += kTileSide) {
    for (int x = 0; x < tiles_right; x += kTileSide) count_tile(plane + v * stride + x, stride, counters);
  }
  for (int v = 0; v < height; ++v) {
    for (int x = v < tiles_below ? tiles_right : 0; x < width; ++x) ++counters.set[x & 3][plane[v * stride + x]];
  }
  for (int level = 0; level < 256; ++level) {
    totals[level] += counters.set[0][level] + counters.set[1][level] + counters.set[2][level] + counters.set[3][level];
  }
}
