#include "enclosure.hpp"

#include <algorithm>

namespace adit {
namespace {

/// Taken off for each cell of the way: 0.02 stops along rows and columns, in proportion along diagonals. Over a quarter
/// of the frame, 40 cells, it comes to 0.8 stops: rock that far away still encloses, rock nearby does so better.
constexpr int kStep = 5;
constexpr int kDiagonalStep = 7;
/// Brighter than nothing: what a ray meets outside the frame.
constexpr std::int16_t kNothing = -30000;

std::int16_t brighter(int a, int b) noexcept { return static_cast<std::int16_t>(a > b ? a : b); }

/// What the rays of a row meet, from what those of the neighbouring row met: straight, and from the two sides.
/// `light` and `met` are of the neighbouring row; the results are of this one.
void carry(const std::int16_t* __restrict light, const std::int16_t* __restrict straight,
           const std::int16_t* __restrict left, const std::int16_t* __restrict right,
           std::int16_t* __restrict out_straight, std::int16_t* __restrict out_left, std::int16_t* __restrict out_right,
           int width) noexcept {
  for (int x = 0; x < width; ++x) out_straight[x] = static_cast<std::int16_t>(brighter(light[x], straight[x]) - kStep);
  out_left[0] = kNothing;
  for (int x = 1; x < width; ++x) {
    out_left[x] = static_cast<std::int16_t>(brighter(light[x - 1], left[x - 1]) - kDiagonalStep);
  }
  for (int x = 0; x + 1 < width; ++x) {
    out_right[x] = static_cast<std::int16_t>(brighter(light[x + 1], right[x + 1]) - kDiagonalStep);
  }
  out_right[width - 1] = kNothing;
}

void nothing_met(std::int16_t* a, std::int16_t* b, std::int16_t* c, int width) noexcept {
  std::fill_n(a, width, kNothing);
  std::fill_n(b, width, kNothing);
  std::fill_n(c, width, kNothing);
}

void along_row(const std::int16_t* light, std::int16_t* from_left, std::int16_t* from_right, int width) noexcept {
  from_left[0] = kNothing;
  for (int x = 1; x < width; ++x) {
    from_left[x] = static_cast<std::int16_t>(brighter(light[x - 1], from_left[x - 1]) - kStep);
  }
  from_right[width - 1] = kNothing;
  for (int x = width - 2; x >= 0; --x) {
    from_right[x] = static_cast<std::int16_t>(brighter(light[x + 1], from_right[x + 1]) - kStep);
  }
}

/// Puts the smaller of each two into `a`, the larger into `b`.
void order(std::int16_t* __restrict a, std::int16_t* __restrict b, int width) noexcept {
  for (int x = 0; x < width; ++x) {
    const std::int16_t low = a[x] < b[x] ? a[x] : b[x];
    const std::int16_t high = a[x] < b[x] ? b[x] : a[x];
    a[x] = low;
    b[x] = high;
  }
}

/// Sorts the eight numbers of each column (Batcher's network of 19 comparators), column beside column.
void sort_columns(std::array<std::vector<std::int16_t>, 8>& r, int width) noexcept {
  constexpr std::array<std::array<std::size_t, 2>, 19> kPairs{{{0, 1},
                                                               {2, 3},
                                                               {4, 5},
                                                               {6, 7},
                                                               {0, 2},
                                                               {1, 3},
                                                               {4, 6},
                                                               {5, 7},
                                                               {1, 2},
                                                               {5, 6},
                                                               {0, 4},
                                                               {3, 7},
                                                               {1, 5},
                                                               {2, 6},
                                                               {1, 4},
                                                               {3, 6},
                                                               {2, 4},
                                                               {3, 5},
                                                               {3, 4}}};
  for (const auto& pair : kPairs) order(r[pair[0]].data(), r[pair[1]].data(), width);
}

void rate(const std::int16_t* light, std::array<std::vector<std::int16_t>, 8>& met, std::int16_t* out,
          int width) noexcept {
  for (auto& row : met) {
    std::int16_t* const r = row.data();
    for (int x = 0; x < width; ++x) r[x] = brighter(r[x], light[x]);
  }
  sort_columns(met, width);
  const std::int16_t *second = met[1].data(), *third = met[2].data(), *fourth = met[3].data();
  for (int x = 0; x < width; ++x) {
    out[x] = static_cast<std::int16_t>((second[x] + third[x] + 2 * fourth[x]) / 4 - light[x]);
  }
}

}  // namespace

EnclosureScratch::EnclosureScratch(int width, int height) {
  for (CellPlane& plane : from_below) plane = CellPlane(width, height);
  for (auto* rows : {&from_above, &above_before}) {
    for (auto& row : *rows) row.resize(static_cast<std::size_t>(width));
  }
  for (auto& row : met) row.resize(static_cast<std::size_t>(width));
}

void enclosure_of(const CellPlane& light, EnclosureScratch& scratch, CellPlane& out) noexcept {
  const int width = light.width, last = light.height - 1;
  auto& below = scratch.from_below;
  nothing_met(below[0].row(last), below[1].row(last), below[2].row(last), width);
  for (int v = last - 1; v >= 0; --v) {
    carry(light.row(v + 1), below[0].row(v + 1), below[1].row(v + 1), below[2].row(v + 1), below[0].row(v),
          below[1].row(v), below[2].row(v), width);
  }
  auto& before = scratch.above_before;
  auto& above = scratch.from_above;
  nothing_met(above[0].data(), above[1].data(), above[2].data(), width);
  auto& met = scratch.met;
  for (int v = 0; v <= last; ++v) {
    if (v > 0) {
      before.swap(above);
      carry(light.row(v - 1), before[0].data(), before[1].data(), before[2].data(), above[0].data(), above[1].data(),
            above[2].data(), width);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::copy_n(below[i].row(v), width, met[i].data());
      std::copy_n(above[i].data(), width, met[3 + i].data());
    }
    along_row(light.row(v), met[6].data(), met[7].data(), width);
    rate(light.row(v), met, out.row(v), width);
  }
}

}  // namespace adit
