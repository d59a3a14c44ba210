// How often each level stands in a plane, counted in bits: for targets with wide vectors.
//
// The including file defines: kLanes bytes a vector, picked (16-byte look-up that gives 0 where the index's top bit is
// set), plus, plus_saturated, either, add_bits and ones_at.
//
// Eight levels make a group. A look-up turns each pixel of the group into one set bit of a byte, and pixels of other
// groups into 0; carry-save adders add such bytes bit by bit, so that 15 additions take in 16 vectors. In a closed
// plane a tile of 16 rows has some 30 levels, and thus 4 or 5 groups, that lie side by side.
constexpr int kTileRows = 16;
constexpr int kGroups = 32;
constexpr int kGroupLevels = 8;

// Counts below 16, one for each column of a tile and each level: bit planes of weight 1, 2, 4 and 8.
struct LevelBits {
  Bytes plane[kGroups][4];
};

inline void add_ones(Bytes bits, std::uint32_t weight, std::uint32_t* totals) {
  for (int i = 0; i < kGroupLevels; ++i) totals[i] += weight * ones_at(bits, i);
}

// Lanes where `done` is 255, and the first `rows_done` rows, have been counted before.
template <bool kIsPart>
inline void count_group(const std::uint8_t* tile, std::ptrdiff_t stride, int group, Bytes done, int rows_done,
                        Bytes* plane, std::uint32_t* totals) {
  const Bytes to_group = fill(static_cast<std::uint8_t>(256 - kGroupLevels * group));
  const Bytes beyond = fill(0x80 - kGroupLevels);
  const auto row = [&](int v) {
    Bytes index = plus_saturated(plus(load(tile + v * stride), to_group), beyond);
    if constexpr (kIsPart) index = either(index, v < rows_done ? fill(255) : done);
    return picked(index);
  };
  Bytes one = plane[0], two = plane[1], four = plane[2], eight = plane[3];
  Bytes carry_two[2], carry_four[2], carry_eight[2], sixteen;
  for (int v = 0; v < kTileRows; v += 2) {
    add_bits(one, row(v), row(v + 1), carry_two[v / 2 % 2]);
    if (v % 4 == 2) add_bits(two, carry_two[0], carry_two[1], carry_four[v / 4 % 2]);
    if (v % 8 == 6) add_bits(four, carry_four[0], carry_four[1], carry_eight[v / 8 % 2]);
  }
  add_bits(eight, carry_eight[0], carry_eight[1], sixteen);
  plane[0] = one;
  plane[1] = two;
  plane[2] = four;
  plane[3] = eight;
  add_ones(sixteen, 16, totals + kGroupLevels * group);
}

template <bool kIsPart>
inline void count_tile(const std::uint8_t* tile, std::ptrdiff_t stride, Bytes done, int rows_done, LevelBits& bits,
                       std::uint32_t* totals) {
  Bytes low = load(tile), high = low;
  for (int v = 1; v < kTileRows; ++v) {
    const Bytes row = load(tile + v * stride);
    low = smallest(low, row);
    high = largest(high, row);
  }
  const int first = least(low) / kGroupLevels, last = most(high) / kGroupLevels;
  for (int group = first; group <= last; ++group) {
    count_group<kIsPart>(tile, stride, group, done, rows_done, bits.plane[group], totals);
  }
}

// What is left beside whole tiles is counted in tiles that lie partly over others.
void count_levels(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height, std::uint32_t* totals) {
  constexpr int kLanes = Bytes::kLanes;
  if (width < kLanes || height < kTileRows) {
    for (int v = 0; v < height; ++v) {
      for (int x = 0; x < width; ++x) ++totals[plane[v * stride + x]];
    }
    return;
  }
  LevelBits bits;
  for (auto& group : bits.plane) {
    for (Bytes& one : group) one = fill(0);
  }
  std::uint8_t lanes[kLanes];
  const int lanes_done = (kLanes - width % kLanes) % kLanes;
  for (int i = 0; i < kLanes; ++i) lanes[i] = i < lanes_done ? 255 : 0;
  for (int v = 0; v < height; v += kTileRows) {
    const int top = v + kTileRows <= height ? v : height - kTileRows;
    const std::uint8_t* row = plane + top * stride;
    int x = 0;
    for (; x + kLanes <= width; x += kLanes) {
      if (top == v)
        count_tile<false>(row + x, stride, fill(0), 0, bits, totals);
      else
        count_tile<true>(row + x, stride, fill(0), v - top, bits, totals);
    }
    if (x < width) count_tile<true>(row + width - kLanes, stride, load(lanes), v - top, bits, totals);
  }
  for (int group = 0; group < kGroups; ++group) {
    for (int i = 0; i < 4; ++i) add_ones(bits.plane[group][i], 1u << i, totals + kGroupLevels * group);
  }
}
