#include "opening_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace adit {
namespace {

/// A peak below this, parts of a stop, is not looked at: paint and stains on one wall differ by as much.
constexpr int kPeakMin = kStop / 2;

/// Area over squared length of a shape from which on it is a passage and no strip: an ellipse four times as long as
/// high has 0.2. The floor at grazing light along the foot of a wall, cables and gaps between planks are thinner.
constexpr double kSlenderness = 0.2;

/// Cells to either side of a centroid that tell the height of a place there: as many as the map is smooth over.
constexpr double kBeside = 2.0;

/// The map is smooth over two cells (it has been smoothed twice, its cells before that), so means of two by two hold
/// all of it, for a quarter of the steps. Fewer than this many steps along the longer side would part branches badly.
constexpr int kStepsMin = 60;

int steps_of(int cells, int step) noexcept { return (cells + step - 1) / step; }

/// Flood fill over the four neighbours of a cell. Cells are those of the search's own grid with its frame.
class Flood {
 public:
  Flood(const CellPlane& map, SearchScratch& scratch) noexcept
      : width_(map.width),
        height_(map.height),
        stride_(steps_of(map.width, scratch.step) + 2),
        per_row_(((std::uint64_t{1} << 32) + static_cast<std::uint64_t>(stride_) - 1) /
                 static_cast<std::uint64_t>(stride_)),
        scratch_(scratch) {}

  /// Takes the cells that are nobody's, connected with `start`, with at least `level`.
  Candidate region(std::int32_t start, int level, std::uint8_t owner) noexcept {
    Candidate out;
    out.left = width_;
    out.top = height_;
    double weights = 0.0;
    const View on = view();
    std::size_t length = 0;
    on.push(start, owner, length);
    for (std::size_t at = 0; at < length; ++at) {
      const std::int32_t cell = on.queue[at];
      add(cell, on.value[cell], out, weights);
      for (const std::int32_t next : {cell - 1, cell + 1, cell - stride_, cell + stride_}) {
        if (on.owner[next] == 0 && on.value[next] >= level) on.push(next, owner, length);
      }
    }
    length_ = length;
    out.u /= weights;
    out.v /= weights;
    out.middle_v = middle_of_height(out);
    return out;
  }

  /// From the region just taken, the cells downhill.
  void slope() noexcept {
    const View on = view();
    std::size_t length = length_;
    for (std::size_t at = 0; at < length; ++at) {
      const std::int32_t cell = on.queue[at];
      const std::int16_t here = on.value[cell];
      for (const std::int32_t next : {cell - 1, cell + 1, cell - stride_, cell + stride_}) {
        if (on.owner[next] == 0 && on.value[next] <= here) on.push(next, kSlope, length);
      }
    }
  }

 private:
  /// Plain pointers in the loops: a byte written may be part of anything, so that members would be read again.
  struct View {
    std::uint8_t* owner;
    const std::int16_t* value;
    std::int32_t* queue;

    void push(std::int32_t cell, std::uint8_t mark, std::size_t& length) const noexcept {
      owner[cell] = mark;
      queue[length++] = cell;
    }
  };
  [[nodiscard]] View view() const noexcept {
    return {scratch_.owner.data(), scratch_.value.data(), scratch_.queue.data()};
  }
  struct Place {
    int u;  ///< first cell of the map under one of the search
    int v;
  };
  [[nodiscard]] Place place_of(std::int32_t cell) const noexcept {
    // A product in place of the division: exact for fewer than 2^16 cells, of which the grid has half.
    const auto row = static_cast<int>((static_cast<std::uint64_t>(cell) * per_row_) >> 32);
    return {(cell - row * stride_ - 1) * scratch_.step, (row - 1) * scratch_.step};
  }
  /// Of the region just taken, about the column of its centroid: it is connected, so that it has cells there.
  [[nodiscard]] double middle_of_height(const Candidate& of) const noexcept {
    double rows = 0.0;
    int count = 0;
    for (std::size_t at = 0; at < length_; ++at) {
      const Place place = place_of(scratch_.queue[at]);
      if (std::abs(place.u + 0.5 * (scratch_.step - 1) - of.u) > kBeside) continue;
      rows += 0.5 * (place.v + std::min(place.v + scratch_.step, height_) - 1);
      ++count;
    }
    return rows / count;
  }
  void add(std::int32_t cell, int value, Candidate& out, double& weights) const noexcept {
    const auto [u, v] = place_of(cell);
    const int last_u = std::min(u + scratch_.step, width_) - 1, last_v = std::min(v + scratch_.step, height_) - 1;
    const double depth = scratch_.depth[static_cast<std::size_t>(cell)];
    const double weight = depth * depth * depth * depth + 1.0;
    out.u += weight * (0.5 * (u + last_u));
    out.v += weight * (0.5 * (v + last_v));
    weights += weight;
    out.left = std::min(out.left, u);
    out.right = std::max(out.right, last_u);
    out.top = std::min(out.top, v);
    out.bottom = std::max(out.bottom, last_v);
    out.cells += (last_u - u + 1) * (last_v - v + 1);
    out.peak = std::max(out.peak, value);
  }

  int width_;
  int height_;
  int stride_;
  std::uint64_t per_row_;  ///< 2^32 over the stride, upwards
  SearchScratch& scratch_;
  std::size_t length_ = 0;
};

/// Two values that stand side by side, none below 0, as one word: sums of two such words keep both halves apart.
std::uint32_t pair_of(const std::int16_t* row, int pair) noexcept {
  std::uint32_t both = 0;
  std::memcpy(&both, row + std::ptrdiff_t{2} * pair, sizeof both);
  return both;
}

/// A row of means of two by two cells; at an odd border of those that are there.
void halve(const CellPlane& map, int row, std::int16_t* __restrict to) noexcept {
  const std::int16_t* __restrict const above = map.row(row * 2);
  const std::int16_t* __restrict const below = map.row(std::min(row * 2 + 1, map.height - 1));
  const int whole = map.width / 2;
  for (int u = 0; u < whole; ++u) {  // by words, so that it becomes vector code
    const std::uint32_t columns = pair_of(above, u) + pair_of(below, u);
    to[u] = static_cast<std::int16_t>(((columns & 0xffffU) + (columns >> 16) + 2U) / 4U);
  }
  if (map.width % 2 != 0) to[whole] = static_cast<std::int16_t>((above[2 * whole] + below[2 * whole] + 1) / 2);
}

void take_row(const CellPlane& map, int step, int row, std::int16_t* to) noexcept {
  if (step == 2) {
    halve(map, row, to);
  } else {
    std::copy_n(map.row(row), map.width, to);
  }
}

void start(const CellPlane& map, const CellPlane& depth, SearchScratch& scratch) noexcept {
  const int width =
      steps_of(map.width, scratch.step);    // a byte written may be part of anything: only what stands apart becomes
  const std::ptrdiff_t stride = width + 2;  // vector code
  std::fill(scratch.owner.begin(), scratch.owner.end(), kSlope);
  for (int v = 0; v < steps_of(map.height, scratch.step); ++v) {
    std::uint8_t* __restrict const owner = scratch.owner.data() + (v + 1) * stride + 1;
    std::int16_t* __restrict const value = scratch.value.data() + (v + 1) * stride + 1;
    take_row(map, scratch.step, v, value);
    take_row(depth, scratch.step, v, scratch.depth.data() + (v + 1) * stride + 1);
    // Half of any peak is above: no place holds such a cell, and no way down from one has to go on through it.
    for (int u = 0; u < width; ++u) owner[u] = value[u] < kPeakMin / 2 ? kSlope : std::uint8_t{0};
    scratch.row_peak[static_cast<std::size_t>(v)] = *std::max_element(value, value + width);
  }
}

/// The first of the highest cells that are nobody's; -1 when none is high enough. A row's peak that has been taken
/// since it was noted is noted anew, so that few rows are looked through.
std::int32_t highest(const CellPlane& map, SearchScratch& scratch) noexcept {
  const std::int32_t width = steps_of(map.width, scratch.step);
  while (true) {
    const auto best = std::max_element(scratch.row_peak.begin(), scratch.row_peak.end());
    if (*best < kPeakMin) return -1;
    const auto first = static_cast<std::int32_t>(best - scratch.row_peak.begin() + 1) * (width + 2) + 1;
    const std::int16_t* const value = scratch.value.data() + first;
    const std::uint8_t* const owner = scratch.owner.data() + first;
    std::int16_t peak = 0;
    for (std::int32_t u = 0; u < width; ++u) {  // no branch: it becomes vector code
      const std::int16_t here = value[u];       // read whatever its owner
      const std::int16_t free = owner[u] == 0 ? here : std::int16_t{0};
      peak = free > peak ? free : peak;
    }
    if (peak < *best) {
      *best = peak;
      continue;
    }
    std::int32_t u = 0;
    while (owner[u] != 0 || value[u] != peak) ++u;
    return first + u;
  }
}

}  // namespace

SearchScratch::SearchScratch(int width, int height)
    : step(std::max(width, height) >= 2 * kStepsMin ? 2 : 1),
      stride(static_cast<std::size_t>(steps_of(width, step) + 2)),
      owner(stride * static_cast<std::size_t>(steps_of(height, step) + 2)),
      value(owner.size()),
      depth(owner.size()),
      queue(owner.size()),
      row_peak(static_cast<std::size_t>(steps_of(height, step))) {}

std::uint8_t SearchScratch::owner_of(int u, int v) const noexcept {
  return owner[(static_cast<std::size_t>(v / step) + 1) * stride + static_cast<std::size_t>(u / step) + 1];
}

Candidates search_openings(const CellPlane& map, const CellPlane& depth, SearchScratch& scratch) noexcept {
  Candidates out;
  start(map, depth, scratch);
  Flood flood(map, scratch);
  while (out.count < kOpeningCountMax) {
    const std::int32_t top = highest(map, scratch);
    if (top < 0) break;
    const int half = (scratch.value[static_cast<std::size_t>(top)] + 1) / 2;
    Candidate& found = out.list[static_cast<std::size_t>(out.count)];
    found = flood.region(top, half, static_cast<std::uint8_t>(out.count + 1));
    found.owner = static_cast<std::uint8_t>(out.count + 1);
    flood.slope();
    const double share = static_cast<double>(found.cells) / (static_cast<double>(map.width) * map.height);
    const int reach = std::max(found.right - found.left, found.bottom - found.top) + 1;
    const double fullness = std::min(1.0, found.cells / (kSlenderness * reach * reach));
    found.strength = static_cast<double>(found.peak) / kStop * std::sqrt(share) * fullness;
    found.rank = found.strength;
    ++out.count;
  }
  order_by_rank(out);
  return out;
}

void order_by_rank(Candidates& candidates) noexcept {  // std::stable_sort would allocate
  std::sort(candidates.list.begin(), candidates.list.begin() + candidates.count,
            [](const Candidate& a, const Candidate& b) {
              return a.rank != b.rank ? a.rank > b.rank : a.v != b.v ? a.v < b.v : a.u < b.u;
            });
}

}  // namespace adit
