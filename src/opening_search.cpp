#include "opening_search.hpp"

#include <algorithm>
#include <cmath>

namespace adit {
namespace {

/// A peak below this, parts of a stop, is not looked at: paint and stains on one wall differ by as much.
constexpr int kPeakMin = kStop / 2;

/// Area over squared length of a shape from which on it is a passage and no strip: an ellipse four times as long as
/// high has 0.2. The floor at grazing light along the foot of a wall, cables and gaps between planks are thinner.
constexpr double kSlenderness = 0.2;

/// Flood fill over the four neighbours of a cell. Cells are counted on the grid with its frame.
class Flood {
 public:
  Flood(const CellPlane& map, const CellPlane& depth, SearchScratch& scratch) noexcept
      : width_(map.width),
        stride_(map.width + 2),
        per_row_(((std::uint64_t{1} << 32) + static_cast<std::uint64_t>(stride_) - 1) /
                 static_cast<std::uint64_t>(stride_)),
        depth_(depth),
        scratch_(scratch) {}

  /// Takes the cells that are nobody's, connected with `start`, with at least `level`.
  Candidate region(std::int32_t start, int level, std::uint8_t owner) noexcept {
    Candidate out;
    out.left = width_;
    out.top = depth_.height;
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
  void add(std::int32_t cell, int value, Candidate& out, double& weights) const noexcept {
    // A product in place of the division: exact for fewer than 2^16 cells, of which the grid has half.
    const auto row = static_cast<int>((static_cast<std::uint64_t>(cell) * per_row_) >> 32);
    const int u = cell - row * stride_ - 1, v = row - 1;
    const double depth = depth_.row(v)[u];
    const double weight = depth * depth * depth * depth + 1.0;
    out.u += weight * u;
    out.v += weight * v;
    weights += weight;
    out.left = std::min(out.left, u);
    out.right = std::max(out.right, u);
    out.top = std::min(out.top, v);
    out.bottom = std::max(out.bottom, v);
    ++out.cells;
    out.peak = std::max(out.peak, value);
  }

  int width_;
  int stride_;
  std::uint64_t per_row_;  ///< 2^32 over the stride, upwards
  const CellPlane& depth_;
  SearchScratch& scratch_;
  std::size_t length_ = 0;
};

void start(const CellPlane& map, SearchScratch& scratch) noexcept {
  const int width = map.width;  // a byte written may be part of anything: only what stands apart becomes vector code
  const std::ptrdiff_t stride = width + 2;
  std::fill(scratch.owner.begin(), scratch.owner.end(), kSlope);
  for (int v = 0; v < map.height; ++v) {
    const std::int16_t* __restrict const from = map.row(v);
    std::uint8_t* __restrict const owner = scratch.owner.data() + (v + 1) * stride + 1;
    std::int16_t* __restrict const value = scratch.value.data() + (v + 1) * stride + 1;
    std::int16_t peak = 0;
    for (int u = 0; u < width; ++u) {
      value[u] = from[u];
      peak = from[u] > peak ? from[u] : peak;
    }
    // Half of any peak is above: no place holds such a cell, and no way down from one has to go on through it.
    for (int u = 0; u < width; ++u) owner[u] = from[u] < kPeakMin / 2 ? kSlope : std::uint8_t{0};
    scratch.row_peak[static_cast<std::size_t>(v)] = peak;
  }
}

/// The first of the highest cells that are nobody's; -1 when none is high enough. A row's peak that has been taken
/// since it was noted is noted anew, so that few rows are looked through.
std::int32_t highest(const CellPlane& map, SearchScratch& scratch) noexcept {
  const std::int32_t stride = map.width + 2;
  while (true) {
    const auto best = std::max_element(scratch.row_peak.begin(), scratch.row_peak.end());
    if (*best < kPeakMin) return -1;
    const auto first = static_cast<std::int32_t>(best - scratch.row_peak.begin() + 1) * stride + 1;
    std::int16_t peak = 0;
    for (std::int32_t cell = first; cell < first + map.width; ++cell) {
      const auto at = static_cast<std::size_t>(cell);
      if (scratch.owner[at] != 0) continue;
      if (scratch.value[at] == *best) return cell;
      peak = std::max(peak, scratch.value[at]);
    }
    *best = peak;
  }
}

}  // namespace

SearchScratch::SearchScratch(int width, int height)
    : owner(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height + 2)),
      value(owner.size()),
      queue(owner.size()),
      row_peak(static_cast<std::size_t>(height)) {}

Candidates search_openings(const CellPlane& map, const CellPlane& depth, SearchScratch& scratch) noexcept {
  Candidates out;
  start(map, scratch);
  Flood flood(map, depth, scratch);
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
