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
      : width_(map.width), stride_(map.width + 2), depth_(depth), scratch_(scratch) {}

  /// Takes the cells that are nobody's, connected with `start`, with at least `level`.
  Candidate region(std::int32_t start, int level, std::uint8_t owner) noexcept {
    Candidate out;
    out.left = width_;
    out.top = depth_.height;
    double weights = 0.0;
    length_ = 0;
    push(start, owner);
    for (std::size_t at = 0; at < length_; ++at) {
      const std::int32_t cell = scratch_.queue[at];
      add(cell, out, weights);
      for (const std::int32_t next : {cell - 1, cell + 1, cell - stride_, cell + stride_}) {
        if (owner_of(next) == 0 && value(next) >= level) push(next, owner);
      }
    }
    out.u /= weights;
    out.v /= weights;
    return out;
  }

  /// From the region just taken, the cells downhill.
  void slope() noexcept {
    for (std::size_t at = 0; at < length_; ++at) {
      const std::int32_t cell = scratch_.queue[at];
      for (const std::int32_t next : {cell - 1, cell + 1, cell - stride_, cell + stride_}) {
        if (owner_of(next) == 0 && value(next) <= value(cell)) push(next, kSlope);
      }
    }
  }

 private:
  [[nodiscard]] int value(std::int32_t cell) const noexcept { return scratch_.value[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] std::uint8_t& owner_of(std::int32_t cell) noexcept {
    return scratch_.owner[static_cast<std::size_t>(cell)];
  }
  void push(std::int32_t cell, std::uint8_t owner) noexcept {
    owner_of(cell) = owner;
    scratch_.queue[length_++] = cell;
  }
  void add(std::int32_t cell, Candidate& out, double& weights) noexcept {
    const int u = cell % stride_ - 1, v = cell / stride_ - 1;
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
    out.peak = std::max(out.peak, value(cell));
  }

  int width_;
  int stride_;
  const CellPlane& depth_;
  SearchScratch& scratch_;
  std::size_t length_ = 0;
};

void start(const CellPlane& map, SearchScratch& scratch) noexcept {
  const std::ptrdiff_t stride = map.width + 2;
  std::fill(scratch.owner.begin(), scratch.owner.end(), kSlope);
  for (int v = 0; v < map.height; ++v) {
    std::fill_n(scratch.owner.data() + (v + 1) * stride + 1, map.width, std::uint8_t{0});
    std::copy_n(map.row(v), map.width, scratch.value.data() + (v + 1) * stride + 1);
    scratch.row_peak[static_cast<std::size_t>(v)] = *std::max_element(map.row(v), map.row(v) + map.width);
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
    ++out.count;
  }
  // std::stable_sort would allocate; equal strengths go by place.
  std::sort(out.list.begin(), out.list.begin() + out.count, [](const Candidate& a, const Candidate& b) {
    return a.strength != b.strength ? a.strength > b.strength : a.v != b.v ? a.v < b.v : a.u < b.u;
  });
  return out;
}

}  // namespace adit
