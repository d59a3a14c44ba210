// Large rectangles: the best value over one costs the same whatever its height. Internal to the morphology.
#pragma once

#include <algorithm>

#include "band_pass.hpp"

namespace adit {

/// The best value over a rectangle, with rows handed in one after the other (van Herk, 1992: three comparisons a pixel
/// in the vertical whatever the height; in the horizontal windows are doubled).
class RectanglePass {
 public:
  /// Lower rectangles are done faster by a BandPass, which keeps to the level-1 cache.
  [[nodiscard]] static bool takes(const StructuringElement& element) noexcept {
    return element.is_rectangle() && element.height() > 31;
  }
  [[nodiscard]] static std::size_t bytes_needed(int width, int height, const StructuringElement& element) noexcept;

  RectanglePass(Order order, int width, int height, const StructuringElement& element, std::uint8_t* work) noexcept;

  /// Where the next source row is to be written: `width` bytes.
  [[nodiscard]] std::uint8_t* next_row() const noexcept { return source_ + pending_ * pitch_ + reach_u_; }
  /// Takes the row at next_row() and writes the result rows that are due. Result rows lag behind, so `out` may be the
  /// plane that the rows come from.
  void advance(PlaneView out) noexcept;
  /// Writes what is left, after the last row of the plane.
  void finish(PlaneView out) noexcept;

 private:
  void take_pending(PlaneView out) noexcept;
  void take_into_block(std::uint8_t* row, PlaneView out) noexcept;
  [[nodiscard]] std::uint8_t* row_of_block() const noexcept {
    return block_ + static_cast<std::size_t>(row_in_block_) * pitch_;
  }
  void close_block() noexcept;

  // Rows go through the horizontal windows together: a short row alone would wait for its own last store at every step.
  // No more than a level-1 cache holds of them three times over.
  static constexpr std::size_t kBatchBytes = 8 * 1024;
  static constexpr std::size_t kBatchMax = 8;
  [[nodiscard]] static std::size_t batch_of(std::size_t pitch) noexcept {
    return std::clamp<std::size_t>(kBatchBytes / pitch, 1, kBatchMax);
  }
  Order order_;
  int width_;
  int height_;
  int reach_u_;
  int reach_v_;
  std::size_t pitch_;
  std::size_t batch_;        ///< rows
  std::size_t pending_ = 0;  ///< rows at source_ that wait for their windows
  std::uint8_t* source_;     ///< batch rows, each with reach_u identity values at both ends
  std::uint8_t* doubled_[2];
  std::uint8_t* running_;  ///< best of the present block's rows so far
  std::uint8_t* block_;    ///< a block of 2 * reach_v + 1 rows: behind the present one, suffixes of the last block
  int row_in_block_ = 0;
  int rows_in_ = 0;
  int rows_out_ = 0;
};

}  // namespace adit
