// The frame, made small: the smallest colour channel averaged over square cells. All later stages of the method `adit`
// work on it, which is why they cost so little.
#pragma once

#include <cstdint>
#include <vector>

#include "adit/image.hpp"

namespace adit {

/// Cells along the longer side of the frame. An opening of 2 m seen from 20 m in a lens of 75 deg is 12 cells wide.
inline constexpr int kCellsMax = 160;
/// Parts of a grey level that a cell tells apart.
inline constexpr int kLevelParts = 16;
inline constexpr int kLevelPartsMax = 255 * kLevelParts;

/// Numbers on a small grid, rows one after the other. 16 bits: the compiler's vector loops hold eight or more.
struct CellPlane {
  int width = 0;   ///< cells
  int height = 0;  ///< cells
  std::vector<std::int16_t> values;

  CellPlane() = default;
  CellPlane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  [[nodiscard]] std::int16_t* row(int v) noexcept { return values.data() + static_cast<std::ptrdiff_t>(v) * width; }
  [[nodiscard]] const std::int16_t* row(int v) const noexcept {
    return values.data() + static_cast<std::ptrdiff_t>(v) * width;
  }
};

/// How a frame is divided into cells.
class CellGrid {
 public:
  CellGrid(int frame_width_px, int frame_height_px);

  [[nodiscard]] int width() const noexcept { return static_cast<int>(first_u_.size()) - 1; }
  [[nodiscard]] int height() const noexcept { return static_cast<int>(first_v_.size()) - 1; }
  /// First pixel column of a cell; cell == width() gives the frame's width.
  [[nodiscard]] int first_u(int cell) const noexcept { return first_u_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] int first_v(int cell) const noexcept { return first_v_[static_cast<std::size_t>(cell)]; }
  /// Every cell is four pixels wide.
  [[nodiscard]] bool cells_of_four() const noexcept { return cells_of_four_; }
  /// The place in the frame, in px, of a place in the grid, in cells (centres of cells at integers).
  [[nodiscard]] double u_px(double cell) const noexcept { return place(first_u_, cell); }
  [[nodiscard]] double v_px(double cell) const noexcept { return place(first_v_, cell); }

 private:
  static double place(const std::vector<int>& first, double cell) noexcept;
  std::vector<int> first_u_;
  std::vector<int> first_v_;
  bool cells_of_four_;
};

/// Scratch: two rows of minima, one of sums.
struct ReductionRows {
  explicit ReductionRows(int frame_width_px)
      : minimum(2 * static_cast<std::size_t>(frame_width_px)), sums(static_cast<std::size_t>(frame_width_px)) {}
  std::vector<std::uint8_t> minimum;
  std::vector<std::uint16_t> sums;
};

/// Mean over each cell of the smallest colour channel, in parts of a grey level (0 to kLevelPartsMax). Cells of four
/// rows and more are read in every other row.
void reduce(const ImageView& view, int grey16_depth_bits, const CellGrid& grid, ReductionRows& rows,
            CellPlane& out) noexcept;

}  // namespace adit
