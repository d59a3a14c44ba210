#include "reduced_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// Sums of the first and third and of the second and fourth byte at a place, in the halves of a word.
std::uint32_t byte_pairs(const std::uint8_t* at) noexcept {
  std::uint32_t four = 0;
  std::memcpy(&four, at, sizeof four);
  return (four & 0x00ff00ffU) + ((four >> 8) & 0x00ff00ffU);
}

/// Means over cells of 640 x 480 and all frames of cells of 4 x 4 pixels, of two rows: no division, and the compiler
/// makes vector code.
void mean_of_eight(const std::uint8_t* __restrict one, const std::uint8_t* __restrict other,
                   std::int16_t* __restrict to, int cells) noexcept {
  static_assert(kLevelParts % 8 == 0);
  for (int cell = 0; cell < cells; ++cell) {
    const std::uint32_t pairs = byte_pairs(one + 4 * cell) + byte_pairs(other + 4 * cell);
    to[cell] = static_cast<std::int16_t>(((pairs & 0xffffU) + (pairs >> 16)) * (kLevelParts / 8));
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
  std::uint8_t* const minimum = rows.minimum.data();
  std::uint8_t* const third = minimum + view.width;
  for (int cell_v = 0; cell_v < grid.height(); ++cell_v) {
    // A cell has at most 8192 / 160 rows: 52 * 255 fits 16 bits. A very long frame has 4 cells and sums fewer rows.
    const int first_v = grid.first_v(cell_v);
    const int end_v = std::min(grid.first_v(cell_v + 1), first_v + 256);
    // Every other row of cells of four rows and more: half the reading, and the mean of eight pixels is still quiet.
    const int step = end_v - first_v >= 4 ? 2 : 1;
    if (grid.cells_of_four() && end_v - first_v == 4) {
      channel_minimum(first_v, minimum);
      channel_minimum(first_v + 2, third);
      mean_of_eight(minimum, third, out.row(cell_v), grid.width());
      continue;
    }
    std::fill(rows.sums.begin(), rows.sums.end(), std::uint16_t{0});
    int rows_read = 0;
    for (int v = first_v; v < end_v; v += step) {
      ++rows_read;
      channel_minimum(v, minimum);
      for (int u = 0; u < view.width; ++u) sums[u] = static_cast<std::uint16_t>(sums[u] + minimum[u]);
    }
    mean_of_cells(sums, rows_read, grid, out.row(cell_v));
  }
}

}  // namespace adit
