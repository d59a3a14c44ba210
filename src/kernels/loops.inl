// The pixel loops, written once over the vector type `Bytes` of the target that includes this file.
//
// The including file defines in its own unnamed namespace: Bytes (kLanes, load, store, fill, smallest, largest,
// any_above, at_most, minus, sum, least, most) and the pixel-format blocks. Nothing here may be an inline function with
// external linkage: the linker would be free to take a copy made for another CPU.

struct Smallest {
  static Bytes of(Bytes a, Bytes b) { return smallest(a, b); }
  static std::uint8_t of(std::uint8_t a, std::uint8_t b) { return a < b ? a : b; }
};

struct Largest {
  static Bytes of(Bytes a, Bytes b) { return largest(a, b); }
  static std::uint8_t of(std::uint8_t a, std::uint8_t b) { return a > b ? a : b; }
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

// One pointer runs, and the operands lie at distances from it: a store with a plain address leaves the ports of the
// loads alone, and they are what the loop waits for.
//
// Loads that lie across two lines cost most where the lines are not there yet: far rows are asked for kAhead bytes
// ahead.
constexpr int kAhead = 1024;

template <class Order, int kCount, bool kIsFar>
void best_in_rows(const ConstRows* list, Rows out, int width, int rows) {
  constexpr int kLanes = Bytes::kLanes;
  std::ptrdiff_t to[kCount], more[kCount];
  bool is_dense = out.pitch == width;
  for (int i = 0; i < kCount; ++i) {
    to[i] = reinterpret_cast<std::intptr_t>(list[i].first) - reinterpret_cast<std::intptr_t>(out.first);
    more[i] = list[i].pitch - out.pitch;
    is_dense = is_dense && more[i] == 0;
  }
  const auto best = [&](const std::uint8_t* at) {
    Bytes value = load(at + to[0]);
    for (int i = 1; i < kCount; ++i) value = Order::of(value, load(at + to[i]));
    return value;
  };
  std::ptrdiff_t length = width;
  if (is_dense) {  // one long row
    length *= rows;
    rows = 1;
  }
  for (; rows > 0; --rows, out.first += out.pitch) {
    std::uint8_t* at = out.first;
    std::uint8_t* const end = at + length;
    for (; end - at >= 2 * kLanes; at += 2 * kLanes) {
      if constexpr (kIsFar) {
        __builtin_prefetch(at + to[0] + kAhead);
        if constexpr (2 * kLanes > 64) __builtin_prefetch(at + to[0] + kAhead + 64);
      }
      const Bytes one = best(at), other = best(at + kLanes);
      store(at, one);
      store(at + kLanes, other);
    }
    for (; end - at >= kLanes; at += kLanes) store(at, best(at));
    if (length >= kLanes) {
      if (at < end) store(end - kLanes, best(end - kLanes));
    } else {
      for (; at < end; ++at) {
        std::uint8_t value = at[to[0]];
        for (int i = 1; i < kCount; ++i) value = Order::of(value, at[to[i]]);
        *at = value;
      }
    }
    for (int i = 0; i < kCount; ++i) to[i] += more[i];
  }
}

static_assert(kOperandsMax == 5);

template <class Order, bool kIsFar>
void best_of_rows(const ConstRows* from, int count, Rows out, int width, int rows) {
  switch (count) {
    case 1:
      return best_in_rows<Order, 1, kIsFar>(from, out, width, rows);
    case 2:
      return best_in_rows<Order, 2, kIsFar>(from, out, width, rows);
    case 3:
      return best_in_rows<Order, 3, kIsFar>(from, out, width, rows);
    case 4:
      return best_in_rows<Order, 4, kIsFar>(from, out, width, rows);
    default:
      return best_in_rows<Order, 5, kIsFar>(from, out, width, rows);
  }
}

// Columns of vectors downwards (van Herk, 1992): of the rows from v on, suffixes of the first length - 1 and prefixes
// of those that follow make the next `length` results, with three comparisons each whatever the length.
template <class Order, int kColumns>
inline void window_in_columns(ConstRows from, int length, Rows out, int rows) {
  constexpr int kLanes = Bytes::kLanes;
  Bytes suffix[kWindowMax][kColumns];
  Bytes best[kColumns];
  for (int v = 0; v < rows; v += length) {
    const std::uint8_t* row = from.first + (v + length - 2) * from.pitch;
    const std::uint8_t* next = row + from.pitch;
    for (int c = 0; c < kColumns; ++c) suffix[length - 2][c] = best[c] = load(row + c * kLanes);
    for (int i = length - 3; i >= 0; --i) {
      row -= from.pitch;
      for (int c = 0; c < kColumns; ++c) suffix[i][c] = best[c] = Order::of(best[c], load(row + c * kLanes));
    }
    std::uint8_t* to = out.first + v * out.pitch;
    for (int c = 0; c < kColumns; ++c) {
      best[c] = load(next + c * kLanes);
      store(to + c * kLanes, Order::of(best[c], suffix[0][c]));
    }
    const int end = rows - v < length ? rows - v : length;
    for (int i = 1; i < end; ++i) {
      next += from.pitch;
      to += out.pitch;
      for (int c = 0; c < kColumns; ++c) {
        best[c] = Order::of(best[c], load(next + c * kLanes));
        store(to + c * kLanes, i < length - 1 ? Order::of(best[c], suffix[i][c]) : best[c]);
      }
    }
  }
}

// The same for a length that is known here: what is kept stays in registers.
template <class Order, int kLength>
void short_window_in_columns(ConstRows from, int, Rows out, int rows) {
  Bytes suffix[kLength - 1];
  for (; rows >= kLength; rows -= kLength) {
    suffix[kLength - 2] = load(from.first + (kLength - 2) * from.pitch);
#pragma GCC unroll 16
    for (int i = kLength - 3; i >= 0; --i) suffix[i] = Order::of(suffix[i + 1], load(from.first + i * from.pitch));
    from.first += (kLength - 1) * from.pitch;
    Bytes best = load(from.first);
    store(out.first, Order::of(best, suffix[0]));
#pragma GCC unroll 16
    for (int i = 1; i < kLength; ++i) {
      from.first += from.pitch;
      out.first += out.pitch;
      best = Order::of(best, load(from.first));
      store(out.first, i < kLength - 1 ? Order::of(best, suffix[i]) : best);
    }
    from.first -= (kLength - 2) * from.pitch;
    out.first += out.pitch;
  }
  if (rows > 0) window_in_columns<Order, 1>(from, kLength, out, rows);
}

template <class Order>
void best_of_window(ConstRows from, int length, Rows out, int width, int rows) {
  constexpr int kLanes = Bytes::kLanes;
  if (width < kLanes) {
    for (int v = 0; v < rows; ++v) {
      for (int x = 0; x < width; ++x) {
        std::uint8_t best = from.first[v * from.pitch + x];
        for (int i = 1; i < length; ++i) best = Order::of(best, from.first[(v + i) * from.pitch + x]);
        out.first[v * out.pitch + x] = best;
      }
    }
    return;
  }
  // The windows of the default patch and element have loops of their own.
  const auto in_columns = length == 15  ? short_window_in_columns<Order, 15>
                          : length == 5 ? short_window_in_columns<Order, 5>
                                        : window_in_columns<Order, 1>;
  int x = 0;
  if (length != 15 && length != 5) {
    for (; x + 2 * kLanes <= width; x += 2 * kLanes) {
      window_in_columns<Order, 2>({from.first + x, from.pitch}, length, {out.first + x, out.pitch}, rows);
    }
  }
  for (; x + kLanes <= width; x += kLanes) {
    in_columns({from.first + x, from.pitch}, length, {out.first + x, out.pitch}, rows);
  }
  // Not in place: there the width is a multiple of all vectors.
  if (x < width) {
    x = width - kLanes;
    in_columns({from.first + x, from.pitch}, length, {out.first + x, out.pitch}, rows);
  }
}

// Columns of vectors downwards. Each row's middle is the upper end of one lozenge and the lower end of another: it is
// kept between them, as a load that lies across two lines costs as much as two.
template <class Order, int kHalf, int kColumns>
inline void lozenges_in_columns(ConstRows from, std::ptrdiff_t du, Rows out, int rows) {
  constexpr int kLanes = Bytes::kLanes;
  constexpr int kKept = 2 * kHalf;
  Bytes kept[kKept][kColumns];
  const std::uint8_t* middle = from.first + du;
  for (int i = 0; i < kKept; ++i, middle += from.pitch) {
    for (int c = 0; c < kColumns; ++c) kept[i][c] = load(middle + c * kLanes);
  }
  const std::uint8_t* side = from.first + kHalf * from.pitch;
  std::uint8_t* to = out.first;
  const auto step = [&](Bytes(&upper)[kColumns]) {
    for (int c = 0; c < kColumns; ++c) {
      const Bytes sides = Order::of(load(side + c * kLanes), load(side + 2 * du + c * kLanes));
      const Bytes lower = load(middle + c * kLanes);
      store(to + c * kLanes, Order::of(Order::of(upper[c], lower), sides));
      upper[c] = lower;
    }
    side += from.pitch;
    middle += from.pitch;
    to += out.pitch;
  };
  int left = rows;
  for (; left >= kKept; left -= kKept) {
#pragma GCC unroll 10
    for (int i = 0; i < kKept; ++i) step(kept[i]);
  }
#pragma GCC unroll 10
  for (int i = 0; i < kKept - 1; ++i) {
    if (i < left) step(kept[i]);
  }
}

// A call over rows: as wide as the vectors go, the last ones pulled back to the end of the row.
template <class Order, int kHalf>
void lozenges(ConstRows from, int du, Rows out, int width, int rows) {
  constexpr int kLanes = Bytes::kLanes;
  constexpr int kWide = kHalf <= 2 ? 2 : 1;  // what is kept has room in 16 registers
  int x = 0;
  for (; x + kWide * kLanes <= width; x += kWide * kLanes) {
    lozenges_in_columns<Order, kHalf, kWide>({from.first + x, from.pitch}, du, {out.first + x, out.pitch}, rows);
  }
  for (; x + kLanes <= width; x += kLanes) {
    lozenges_in_columns<Order, kHalf, 1>({from.first + x, from.pitch}, du, {out.first + x, out.pitch}, rows);
  }
  if (x == width) return;
  x = width - kLanes;
  lozenges_in_columns<Order, kHalf, 1>({from.first + x, from.pitch}, du, {out.first + x, out.pitch}, rows);
}

template <class Order>
void best_of_lozenge(ConstRows from, int du, int dv, Rows out, int width, int rows) {
  if (width >= Bytes::kLanes && rows > 0) {
    switch (dv) {
      case 1:
        return lozenges<Order, 1>(from, du, out, width, rows);
      case 2:
        return lozenges<Order, 2>(from, du, out, width, rows);
      case 3:
        return lozenges<Order, 3>(from, du, out, width, rows);
      case 4:
        return lozenges<Order, 4>(from, du, out, width, rows);
      case 5:
        return lozenges<Order, 5>(from, du, out, width, rows);
      default:
        break;
    }
  }
  const std::uint8_t* const sides = from.first + dv * from.pitch;
  const ConstRows list[] = {{from.first + du, from.pitch},
                            {sides, from.pitch},
                            {sides + 2 * du, from.pitch},
                            {sides + du + dv * from.pitch, from.pitch}};
  best_of_rows<Order, false>(list, 4, out, width, rows);
}

template <class Order>
void fold(const std::uint8_t* row, std::uint8_t* running, const std::uint8_t* suffix, std::uint8_t* out,
          const std::uint8_t* next_out, int width) {
  along(
      width,
      [&](std::ptrdiff_t x) {
        if (Bytes::kLanes >= 64 || x % 64 == 0) __builtin_prefetch(next_out + x, 1, 2);
        const Bytes best = Order::of(load(running + x), load(row + x));
        store(running + x, best);
        store(out + x, Order::of(best, load(suffix + x)));
      },
      [&](std::ptrdiff_t x) {
        running[x] = Order::of(running[x], row[x]);
        out[x] = Order::of(running[x], suffix[x]);
      });
}

// Runs `block`, which turns kBlock pixels of `step` bytes into kBlock bytes and reads `extra` bytes beyond them, over a
// row, and `one` over the pixels that are left: a foreign row is never read beyond its end.
constexpr int kFrameAhead = 3072;

template <int kBlock, class PerBlock, class PerPixel>
inline void along_pixels(const std::uint8_t* from, int step, int extra, std::uint8_t* to, int width, PerBlock block,
                         PerPixel one) {
  int x = 0;
  for (; (x + kBlock) * step + extra <= width * step; x += kBlock) {
    // A frame comes from far away, and the next row follows upon this one.
    for (int line = 0; line < kBlock * step; line += 64) __builtin_prefetch(from + x * step + kFrameAhead + line);
    block(from + x * step, to + x);
  }
  const int last = width - kBlock - (extra + step - 1) / step;  // met twice in part, which changes nothing
  if (x < width && last >= 0) {
    block(from + last * step, to + last);
    x = last + kBlock;
  }
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

std::uint8_t largest_level(const std::uint8_t* row, int width) {
  constexpr int kLanes = Bytes::kLanes;
  int level = 0;
  if (width < kLanes) {
    for (int x = 0; x < width; ++x) level = row[x] > level ? row[x] : level;
    return static_cast<std::uint8_t>(level);
  }
  Bytes one = load(row), other = load(row + width - kLanes);
  int x = kLanes;
  for (; x + 2 * kLanes <= width; x += 2 * kLanes) {
    one = largest(one, load(row + x));
    other = largest(other, load(row + x + kLanes));
  }
  if (x + kLanes <= width) one = largest(one, load(row + x));
  return static_cast<std::uint8_t>(most(largest(one, other)));
}

// Counts values that may be among the brightest `wanted`. Rises `floor` (see BrightTail) as it learns more. Bright
// places are flat: a vector has few different levels, and each is counted at once.
inline void raise_floor(BrightTail* tail) {
  while (tail->above_floor >= tail->wanted) tail->above_floor -= tail->counters[++tail->floor];
}

// Four vectors at once: of most rows nothing is bright enough to matter.
inline bool any_of_4_above(const std::uint8_t* p, Bytes limit) {
  constexpr int kLanes = Bytes::kLanes;
  return any_above(largest(largest(load(p), load(p + kLanes)), largest(load(p + 2 * kLanes), load(p + 3 * kLanes))),
                   limit);
}

inline void count_tail_vector(const std::uint8_t* p, BrightTail* tail) {
  constexpr std::uint32_t kLanes = Bytes::kLanes;
  Bytes left = load(p);
  const int floor_before = tail->floor;
  if (floor_before > 0 && !any_above(left, fill(static_cast<std::uint8_t>(floor_before - 1)))) return;
  std::uint32_t counted = 0;
  while (counted < kLanes) {
    const int level = most(left);
    if (level < floor_before) break;
    std::uint32_t there = kLanes - counted;  // level 0: all that are left
    if (level > 0) {
      const Bytes lower = at_most(left, fill(static_cast<std::uint8_t>(level - 1)));  // 255 is -1
      there = kLanes - sum(minus(fill(0), lower));
      left = smallest(left, lower);
    }
    counted += there;
    tail->counters[level] += there;
    if (level > tail->floor) tail->above_floor += there;
  }
  raise_floor(tail);
}

bool count_tail(const std::uint8_t* row, int width, BrightTail* tail) {
  constexpr int kLanes = Bytes::kLanes;
  bool any = false;
  int x = 0;
  while (x + kLanes <= width) {
    if (x + 4 * kLanes <= width && tail->floor > 0 &&
        !any_of_4_above(row + x, fill(static_cast<std::uint8_t>(tail->floor - 1)))) {
      x += 4 * kLanes;
      continue;
    }
    any = true;
    const int end = x + 4 * kLanes <= width ? x + 4 * kLanes : x + kLanes;
    for (; x < end; x += kLanes) count_tail_vector(row + x, tail);
  }
  for (; x < width; ++x) {
    if (row[x] < tail->floor) continue;
    any = true;
    ++tail->counters[row[x]];
    tail->above_floor += row[x] > tail->floor;
    raise_floor(tail);
  }
  return any;
}

// A few rows together: the columns' counters are read and written once for all of them.
template <int kRows>
inline void count_mask_rows(const std::uint8_t* first, std::ptrdiff_t stride, int width, std::uint8_t last_level,
                            std::uint8_t* columns, std::uint32_t* rows) {
  constexpr int kLanes = Bytes::kLanes;
  const Bytes limit = fill(last_level);
  for (int v = 0; v < kRows; ++v) rows[v] = 0;
  int x = 0;
  while (x + kLanes <= width) {
    // 8-bit sums of the lanes are good for 255 vectors.
    const int end = width - x > 255 * kLanes ? x + 255 * kLanes : width;
    Bytes lanes[kRows];
    for (Bytes& lane : lanes) lane = fill(0);
    for (; x + kLanes <= end; x += kLanes) {
      Bytes column = load(columns + x);
      for (int v = 0; v < kRows; ++v) {
        const Bytes mask = at_most(load(first + v * stride + x), limit);  // 255 is -1
        column = minus(column, mask);
        lanes[v] = minus(lanes[v], mask);
      }
      store(columns + x, column);
    }
    for (int v = 0; v < kRows; ++v) rows[v] += sum(lanes[v]);
  }
  for (; x < width; ++x) {
    for (int v = 0; v < kRows; ++v) {
      const bool inside = first[v * stride + x] <= last_level;
      columns[x] = static_cast<std::uint8_t>(columns[x] + inside);
      rows[v] += inside;
    }
  }
}

void count_mask(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height, std::uint8_t last_level,
                std::uint8_t* columns, std::uint32_t* rows) {
  int v = 0;
  for (; v + 4 <= height; v += 4) {
    count_mask_rows<4>(plane + v * stride, stride, width, last_level, columns, rows + v);
  }
  for (; v < height; ++v) count_mask_rows<1>(plane + v * stride, stride, width, last_level, columns, rows + v);
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
  return {best_of_rows<Order, false>, best_of_rows<Order, true>, best_of_window<Order>, best_of_lozenge<Order>,
          fold<Order>};
}

#include "cell_loops.inl"

constexpr PixelLoops kLoops = {Bytes::kLanes,
                               order_loops<Smallest>(),
                               order_loops<Largest>(),
                               triplet_minimum,
                               quad_minimum,
                               grey16_to_8,
                               count_levels,
                               largest_level,
                               count_tail,
                               count_mask,
                               sum_where_bright,
                               kCellLoops};
