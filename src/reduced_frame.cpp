#include "reduced_frame.hpp"

#include <algorithm>
#include <cmath>

#include "channel_minimum.hpp"

namespace adit {
namespace {

std::vector<int> bounds(int length_px, int cells) {
  std::vector<int> first(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i) {
    first[static_cast<std::size_t>(i)] = static_cast<int>(static_cast<std::int64_t>(i) * length_px / cells);
  }
  return first;
}

/// Cells of a side: square cells, at least one pixel each, at least 4 cells of the short side of a very long frame.
int cells_of(int length_px, int longer_px) {
  if (longer_px <= kCellsMax) return length_px;
  const auto square = static_cast<int>(std::lround(static_cast<double>(length_px) * kCellsMax / longer_px));
  return std::clamp(square, 4, kCellsMax);
}

/// Means over cells of any width, rounded, in parts of a level.
void mean_of_cells(const std::uint16_t* sums, int rows_read, const CellGrid& grid, std::int16_t* to) noexcept {
  for (int cell = 0; cell < grid.width(); ++cell) {
    const int first_u = grid.first_u(cell), end_u = grid.first_u(cell + 1);
    std::uint32_t sum = 0;
    for (int u = first_u; u < end_u; ++u) sum += sums[u];
    const auto pixels = static_cast<std::uint32_t>((end_u - first_u) * rows_read);
    to[cell] = static_cast<std::int16_t>((sum * kLevelParts + pixels / 2) / pixels);
  }
}

/// The same for 640 x 480 and all frames of cells of 4 x 4 pixels: no division, and the compiler makes vector code.
void mean_of_eight(const std::uint16_t* __restrict sums, std::int16_t* __restrict to, int cells) noexcept {
  static_assert(kLevelParts % 8 == 0);
  for (int cell = 0; cell < cells; ++cell) {
    const int sum = sums[4 * cell] + sums[4 * cell + 1] + sums[4 * cell + 2] + sums[4 * cell + 3];
    to[cell] = static_cast<std::int16_t>(sum * (kLevelParts / 8));
  }
}

}  // namespace

CellGrid::CellGrid(int frame_width_px, int frame_height_px)
    : first_u_(bounds(frame_width_px, cells_of(frame_width_px, std::max(frame_width_px, frame_height_px)))),
      first_v_(bounds(frame_height_px, cells_of(frame_height_px, std::max(frame_width_px, frame_height_px)))),
      cells_of_four_(width() * 4 == frame_width_px) {}

double CellGrid::place(const std::vector<int>& first, double cell) noexcept {
  const double cells = static_cast<double>(first.size()) - 1.0;
  return std::clamp((cell + 0.5) * first.back() / cells - 0.5, 0.0, first.back() - 1.0);
}

void reduce(const ImageView& view, int grey16_depth_bits, const CellGrid& grid, ReductionRows& rows,
            CellPlane& out) noexcept {
  const ChannelMinimum channel_minimum(view, grey16_depth_bits);
  std::uint16_t* const sums = rows.sums.data();
  const std::uint8_t* const minimum = rows.minimum.data();
  for (int cell_v = 0; cell_v < grid.height(); ++cell_v) {
    std::fill(rows.sums.begin(), rows.sums.end(), std::uint16_t{0});
    // A cell has at most 8192 / 160 rows: 52 * 255 fits 16 bits. A very long frame has 4 cells and sums fewer rows.
    const int first_v = grid.first_v(cell_v);
    const int end_v = std::min(grid.first_v(cell_v + 1), first_v + 256);
    // Every other row of cells of four rows and more: half the reading, and the mean of eight pixels is still quiet.
    const int step = end_v - first_v >= 4 ? 2 : 1;
    int rows_read = 0;
    for (int v = first_v; v < end_v; v += step) {
      ++rows_read;
      channel_minimum(v, rows.minimum.data());
      for (int u = 0; u < view.width; ++u) sums[u] = static_cast<std::uint16_t>(sums[u] + minimum[u]);
    }
    if (grid.cells_of_four() && rows_read == 2) {
      mean_of_eight(sums, out.row(cell_v), grid.width());
    } else {
      mean_of_cells(sums, rows_read, grid, out.row(cell_v));
    }
  }
}

}  // namespace adit
