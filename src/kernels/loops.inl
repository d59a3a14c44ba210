// The pixel loops, written once over the vector type `Bytes` of the target that includes this file.
//
// The including file defines in its own unnamed namespace: Bytes (kLanes, load, store, fill, smallest, largest, beyond,
// same, at_most, minus, sum) and the pixel-format blocks. Nothing here may be an inline function with external linkage:
// the linker would be free to take a copy made for another CPU.

template <int kCount>
struct Count {
  static constexpr int value = kCount;
};

struct Smallest {
  static Bytes of(Bytes a, Bytes b) { return smallest(a, b); }
  static std::uint8_t of(std::uint8_t a, std::uint8_t b) { return a < b ? a : b; }
  static bool beyond(Bytes a, Bytes b) { return any_above(b, a); }
};

struct Largest {
  static Bytes of(Bytes a, Bytes b) { return largest(a, b); }
  static std::uint8_t of(std::uint8_t a, std::uint8_t b) { return a > b ? a : b; }
  static bool beyond(Bytes a, Bytes b) { return any_above(a, b); }
};

// Calls vector(x) so that every column is met: in steps of a vector, the last one pulled back to end with the row
// (columns met twice get the same value). Rows shorter than a vector go column by column.
template <class PerVector, class PerColumn>
inline void along(int width, PerVector per_vector, PerColumn per_column) {
  constexpr int kLanes = Bytes::kLanes;
  if (width < kLanes) {
    for (int x = 0; x < width; ++x) per_column(x);
    return;
  }
  std::ptrdiff_t x = 0;
  for (; x + 4 * kLanes <= width; x += 4 * kLanes) {
    per_vector(x);
    per_vector(x + kLanes);
    per_vector(x + 2 * kLanes);
    per_vector(x + 3 * kLanes);
  }
  for (; x + kLanes <= width; x += kLanes) per_vector(x);
  if (x < width) per_vector(width - kLanes);
}

template <class Order>
void join(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out, int width) {
  along(
      width, [&](std::ptrdiff_t x) { store(out + x, Order::of(load(a + x), load(b + x))); },
      [&](std::ptrdiff_t x) { out[x] = Order::of(a[x], b[x]); });
}

template <class Order>
void fold(const std::uint8_t* row, std::uint8_t* running, const std::uint8_t* suffix, std::uint8_t* out, int width) {
  along(
      width,
      [&](std::ptrdiff_t x) {
        const Bytes best = Order::of(load(running + x), load(row + x));
        store(running + x, best);
        store(out + x, Order::of(best, load(suffix + x)));
      },
      [&](std::ptrdiff_t x) {
        running[x] = Order::of(running[x], row[x]);
        out[x] = Order::of(running[x], suffix[x]);
      });
}

template <class Order>
void spread(const std::uint8_t* in, int shift, const std::uint8_t* also, std::uint8_t* out, int width) {
  const std::uint8_t* left = in - shift;
  const std::uint8_t* right = in + shift;
  if (also == nullptr) {
    along(
        width,
        [&](std::ptrdiff_t x) { store(out + x, Order::of(Order::of(load(left + x), load(right + x)), load(in + x))); },
        [&](std::ptrdiff_t x) { out[x] = Order::of(Order::of(left[x], right[x]), in[x]); });
    return;
  }
  along(
      width,
      [&](std::ptrdiff_t x) {
        store(out + x, Order::of(Order::of(load(left + x), load(right + x)), Order::of(load(in + x), load(also + x))));
      },
      [&](std::ptrdiff_t x) { out[x] = Order::of(Order::of(left[x], right[x]), Order::of(in[x], also[x])); });
}

// kVectors vectors side by side, so that a row's address is fetched once for all of them. `common` holds the rows that
// the windows of both middles have in common.
template <class Order, int kVectors>
inline void stack_columns(const std::uint8_t* const* rows, const int* reach, int count, std::uint8_t* const* out_upper,
                          std::uint8_t* const* out_lower, std::ptrdiff_t x) {
  constexpr int kLanes = Bytes::kLanes;
  const auto at = [&](const std::uint8_t* row, int i) { return load(row + x + i * kLanes); };
  Bytes common[kVectors];
  for (int i = 0; i < kVectors; ++i) common[i] = Order::of(at(rows[0], i), at(rows[1], i));
  const std::uint8_t* const* pair = rows + 2;
  int j = 0;
  if (reach[0] == 0) {
    for (int i = 0; i < kVectors; ++i) {
      store(out_upper[0] + x + i * kLanes, at(rows[0], i));
      store(out_lower[0] + x + i * kLanes, at(rows[1], i));
    }
    j = 1;
  }
  for (; j < count; ++j) {
    for (const std::uint8_t* const* last = rows + 2 * reach[j]; pair < last; pair += 2) {
      for (int i = 0; i < kVectors; ++i) common[i] = Order::of(common[i], Order::of(at(pair[0], i), at(pair[1], i)));
    }
    for (int i = 0; i < kVectors; ++i) {
      const Bytes below = at(pair[1], i);
      const Bytes upper = Order::of(common[i], at(pair[0], i));
      store(out_upper[j] + x + i * kLanes, upper);
      store(out_lower[j] + x + i * kLanes, Order::of(common[i], below));
      common[i] = Order::of(upper, below);
    }
    pair += 2;
  }
}

template <class Order>
void stack(const std::uint8_t* const* rows, const int* reach, int count, std::uint8_t* const* out_upper,
           std::uint8_t* const* out_lower, int width) {
  const auto columns = [&](auto vectors, int begin) {
    stack_columns<Order, decltype(vectors)::value>(rows, reach, count, out_upper, out_lower, begin);
  };
  int x = 0;
  for (; x + 5 * Bytes::kLanes <= width; x += 5 * Bytes::kLanes) columns(Count<5>{}, x);
  for (; x + 2 * Bytes::kLanes <= width; x += 2 * Bytes::kLanes) columns(Count<2>{}, x);
  if (x + Bytes::kLanes <= width) {
    columns(Count<1>{}, x);
    x += Bytes::kLanes;
  }
  if (x == width) return;
  if (width >= Bytes::kLanes) {
    return columns(Count<1>{}, width - Bytes::kLanes);
  }
  for (; x < width; ++x) {
    std::uint8_t common = Order::of(rows[0][x], rows[1][x]);
    int dv = 1;
    int j = 0;
    if (reach[0] == 0) {
      out_upper[0][x] = rows[0][x];
      out_lower[0][x] = rows[1][x];
      j = 1;
    }
    for (; j < count; ++j) {
      for (; dv < reach[j]; ++dv) common = Order::of(common, Order::of(rows[2 * dv][x], rows[2 * dv + 1][x]));
      out_upper[j][x] = Order::of(common, rows[2 * dv][x]);
      out_lower[j][x] = Order::of(common, rows[2 * dv + 1][x]);
      common = Order::of(out_upper[j][x], rows[2 * dv + 1][x]);
      ++dv;
    }
  }
}

template <class Order>
void gather(const std::uint8_t* const* left, const std::uint8_t* const* right, int count, std::uint8_t* out,
            int width) {
  along(
      width,
      [&](std::ptrdiff_t x) {
        Bytes best = Order::of(load(left[0] + x), load(right[0] + x));
        for (int i = 1; i < count; ++i) best = Order::of(best, Order::of(load(left[i] + x), load(right[i] + x)));
        store(out + x, best);
      },
      [&](std::ptrdiff_t x) {
        std::uint8_t best = Order::of(left[0][x], right[0][x]);
        for (int i = 1; i < count; ++i) best = Order::of(best, Order::of(left[i][x], right[i][x]));
        out[x] = best;
      });
}

template <class Order>
void compare_cells(const std::uint8_t* row, const std::uint8_t* other, int cells, std::uint8_t* row_beyond,
                   std::uint8_t* other_beyond) {
  for (int cell = 0; cell < cells; ++cell) {
    bool first = false;
    bool second = false;
    for (int x = cell * kCellColumns; x < (cell + 1) * kCellColumns; x += Bytes::kLanes) {
      const Bytes a = load(row + x);
      const Bytes b = load(other + x);
      first = first || Order::beyond(a, b);
      second = second || Order::beyond(b, a);
    }
    row_beyond[cell] = first;
    other_beyond[cell] = second;
  }
}

// Runs `block`, which turns kBlock pixels of `step` bytes into kBlock bytes and reads `extra` bytes beyond them, over a
// row, and `one` over the pixels that are left: a foreign row is never read beyond its end.
template <int kBlock, class PerBlock, class PerPixel>
inline void along_pixels(const std::uint8_t* from, int step, int extra, std::uint8_t* to, int width, PerBlock block,
                         PerPixel one) {
  int x = 0;
  for (; (x + kBlock) * step + extra <= width * step; x += kBlock) block(from + x * step, to + x);
  for (; x < width; ++x) to[x] = one(from + x * step);
}

inline std::uint8_t smallest_of_3(const std::uint8_t* p) {
  const std::uint8_t first = p[0] < p[1] ? p[0] : p[1];
  return first < p[2] ? first : p[2];
}

void triplet_minimum(const std::uint8_t* from, std::uint8_t* to, int width) {
  along_pixels<kTripletBlock>(from, 3, kTripletExtra, to, width, triplet_minimum_block, smallest_of_3);
}

void quad_minimum(const std::uint8_t* from, std::uint8_t* to, int width) {
  along_pixels<16>(from, 4, 0, to, width, quad_minimum_block, smallest_of_3);
}

void grey16_to_8(const std::uint8_t* from, int shift, std::uint8_t* to, int width) {
  along_pixels<16>(
      from, 2, 0, to, width, [&](const std::uint8_t* p, std::uint8_t* q) { grey16_block(p, shift, q); },
      [&](const std::uint8_t* p) {
        std::uint16_t value;
        __builtin_memcpy(&value, p, sizeof value);
        const unsigned level = static_cast<unsigned>(value) >> shift;
        return static_cast<std::uint8_t>(level < 255u ? level : 255u);
      });
}

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

// Counts values that may be among the brightest `wanted`. Rises `floor` (see BrightTail) as it learns more.
void count_tail(const std::uint8_t* row, int width, BrightTail* tail) {
  constexpr int kLanes = Bytes::kLanes;
  int x = 0;
  Bytes below = fill(static_cast<std::uint8_t>(tail->floor > 0 ? tail->floor - 1 : 0));
  while (x < width) {
    int end = width;
    if (x + kLanes <= width) {
      end = x + kLanes;
      if (tail->floor > 0 && !any_above(load(row + x), below)) {
        x = end;
        continue;
      }
    }
    const int floor_before = tail->floor;
    for (; x < end; ++x) {
      const int level = row[x];
      if (level < floor_before) continue;
      ++tail->counters[level];
      tail->above_floor += level > tail->floor;
    }
    while (tail->above_floor >= tail->wanted) tail->above_floor -= tail->counters[++tail->floor];
    if (tail->floor != floor_before) below = fill(static_cast<std::uint8_t>(tail->floor - 1));
  }
}

void count_mask(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height, std::uint8_t last_level,
                std::uint8_t* columns, std::uint32_t* rows) {
  constexpr int kLanes = Bytes::kLanes;
  const Bytes limit = fill(last_level);
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* row = plane + v * stride;
    std::uint32_t in_row = 0;
    int x = 0;
    while (x + kLanes <= width) {
      // 8-bit sums of the lanes are good for 255 vectors.
      const int end = width - x > 255 * kLanes ? x + 255 * kLanes : width;
      Bytes lanes = fill(0);
      for (; x + kLanes <= end; x += kLanes) {
        const Bytes mask = at_most(load(row + x), limit);  // 255 is -1
        store(columns + x, minus(load(columns + x), mask));
        lanes = minus(lanes, mask);
      }
      in_row += sum(lanes);
    }
    for (; x < width; ++x) {
      const bool inside = row[x] <= last_level;
      columns[x] = static_cast<std::uint8_t>(columns[x] + inside);
      in_row += inside;
    }
    rows[v] = in_row;
  }
}

std::uint64_t sum_where_bright(const std::uint8_t* from, int channels, const std::uint8_t* dark, std::uint8_t level,
                               int width) {
  constexpr int kLanes = Bytes::kLanes;
  std::uint64_t total = 0;
  const auto add = [&](int begin, int end) {
    for (int x = begin; x < end; ++x) {
      if (dark[x] < level) continue;
      const std::uint8_t* p = from + x * channels;
      total += channels == 3 ? static_cast<unsigned>(p[0] + p[1] + p[2]) : p[0];
    }
  };
  int x = 0;
  const Bytes below = fill(static_cast<std::uint8_t>(level - 1));
  for (; x + kLanes <= width; x += kLanes) {
    if (level > 0 && !any_above(load(dark + x), below)) continue;
    if (channels == 1) {
      add(x, x + kLanes);
      continue;
    }
    for (int i = 0; i < kLanes; i += 16) total += masked_triplet_sum(from + 3 * (x + i), dark + x + i, level);
  }
  add(x, width);
  return total;
}

template <class Order>
constexpr OrderLoops order_loops() {
  return {join<Order>, fold<Order>, spread<Order>, stack<Order>, gather<Order>, compare_cells<Order>};
}

constexpr PixelLoops kLoops = {order_loops<Smallest>(), order_loops<Largest>(), triplet_minimum, quad_minimum, grey16_to_8, count_levels, count_tail, count_mask, sum_where_bright};
