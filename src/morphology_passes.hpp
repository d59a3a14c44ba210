// How a flat element is applied to a plane. Three ways, all exact; which is fastest depends on the element's size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "adit/morphology.hpp"
#include "kernels/pixel_loops.hpp"

namespace adit {

/// Bytes on a cache line's boundary; only grows.
class AlignedBytes {
 public:
  void reserve(std::size_t size) {
    if (size <= size_) return;
    bytes_.reset(static_cast<std::uint8_t*>(::operator new (size, std::align_val_t{kAlignment})));
    std::memset(bytes_.get(), 0, size);
    size_ = size;
  }
  [[nodiscard]] std::uint8_t* get() const noexcept { return bytes_.get(); }

  static constexpr std::size_t kAlignment = 64;
  [[nodiscard]] static constexpr std::size_t rounded_up(std::size_t size) noexcept {
    return (size + kAlignment - 1) / kAlignment * kAlignment;
  }

 private:
  struct Free {
    void operator()(std::uint8_t* bytes) const noexcept { ::operator delete (bytes, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<std::uint8_t, Free> bytes_;
  std::size_t size_ = 0;
};

/// Erosion or dilation: the loops that pick the better of two values, and the value that is never better.
struct Order {
  const kernels::OrderLoops& loops;
  std::uint8_t identity;
};
[[nodiscard]] Order smallest_order() noexcept;
[[nodiscard]] Order largest_order() noexcept;

/// The best value over a rectangle, with rows handed in one after the other (van Herk, 1992: three comparisons a pixel
/// in the vertical whatever the height; in the horizontal windows are doubled).
class RectanglePass {
 public:
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

  // Rows go through the horizontal windows together: a row alone would wait for its own last store at every step.
  static constexpr std::size_t kBatch = 8;
  Order order_;
  int width_;
  int height_;
  int reach_u_;
  int reach_v_;
  std::size_t pitch_;
  std::size_t pending_ = 0;  ///< rows at source_ that wait for their windows
  std::uint8_t* source_;     ///< kBatch rows, each with reach_u identity values at both ends
  std::uint8_t* doubled_[2];
  std::uint8_t* running_;  ///< best of the present block's rows so far
  std::uint8_t* block_;    ///< a block of 2 * reach_v + 1 rows: behind the present one, suffixes of the last block
  int row_in_block_ = 0;
  int rows_in_ = 0;
  int rows_out_ = 0;
};

/// A centred rectangle inside an element, by its half sides.
struct Reach {
  int u = 0;
  int v = 0;
};

/// The maximal centred rectangles of an element, from the widest (and lowest) to the narrowest (and highest): their
/// union is the element.
void list_rectangles(const StructuringElement& element, std::vector<Reach>& rectangles);

/// The best value over an element that is the union of `rectangles`, a few rows at a time, for elements of few rows.
/// Vertical windows first, all rectangles in one go; then, because taking the best distributes over itself, the
/// rectangles are widened step by step, each step serving all wider ones (Horner's scheme).
class EllipseRows {
 public:
  /// Elements higher than this are left to LargeEllipse.
  static constexpr int kHeightMax_px = 31;
  /// Rows made together, an even number; a row alone would wait for its own last store at every step.
  static constexpr int kBatch = 4;

  [[nodiscard]] static std::size_t bytes_needed(int width, const StructuringElement& element) noexcept;

  EllipseRows(Order order, int width, const std::vector<Reach>& rectangles, std::uint8_t* work) noexcept;

  /// Takes two rows of the batch; widen() then makes all of it.
  /// @param slot  of the upper row: 0, 2, ...
  /// @param rows  the two middle rows; then, going outwards, the row above the upper and the row below the lower one,
  ///              reach_v() times. Where the plane has no such row, the nearer middle stands in: it is under both
  ///              elements anyway.
  void stack(int slot, const std::uint8_t* const* rows) const noexcept;
  /// @param out  where to write the rows of the batch.
  void widen(std::uint8_t* const* out, int count) const noexcept;
  [[nodiscard]] int reach_v() const noexcept { return reach_[count_ - 1]; }

 private:
  struct Step {
    int shift;
    const std::uint8_t* also;  ///< next rectangle's vertical window, or null
  };
  void add_widening(int reach_u, const std::uint8_t* also) noexcept;

  static constexpr int kRectanglesMax = kHeightMax_px / 2 + 1;
  static constexpr int kStepsMax = 64;
  Order order_;
  int width_;
  std::size_t pitch_;  ///< from row to row of a batch
  std::size_t lead_;   ///< columns that are widened before the first row's first column
  int count_ = 0;
  int reach_[kRectanglesMax];
  std::uint8_t* window_[kRectanglesMax];
  std::uint8_t* widened_[2];
  int step_count_ = 0;
  Step steps_[kStepsMax];
};

/// The best value over an element of many rows. Strips of columns; chords of each row come from tables of windows of
/// 1, 2, 4, ... columns; and a row is looked at only where it can matter: seen from the element's middle, a row that
/// nowhere goes beyond its inner neighbour is covered by that neighbour's longer chord.
class LargeEllipse {
 public:
  [[nodiscard]] static std::size_t bytes_needed(int width, int height, const StructuringElement& element) noexcept;

  LargeEllipse(Order order, int width, int height, const StructuringElement& element, std::uint8_t* work) noexcept;
  void apply(ConstPlaneView in, PlaneView out) noexcept;

 private:
  /// Where in a slot the two windows lie that make up the chord of the rows at this distance from the middle.
  struct Chord {
    std::ptrdiff_t left;
    std::ptrdiff_t right;
  };
  struct Layout;

  void strip(ConstPlaneView in, PlaneView out, int begin, int width) noexcept;
  void take_row(ConstPlaneView in, int v, int begin, int width) noexcept;
  void mark_rows(int v, int cells) noexcept;
  void make_row(int v, int height, int begin, int width, std::uint8_t* out) noexcept;
  void add_marked(const std::uint64_t* marks, int first, int last, int v, int x) noexcept;
  [[nodiscard]] std::uint8_t* slot(int v) const noexcept;

  Order order_;
  const StructuringElement& element_;
  int reach_u_;
  int reach_v_;
  int ring_;           ///< rows kept
  int margin_;         ///< columns kept at both sides of a strip, a multiple of the cell
  int levels_;         ///< tables of windows: 1, 2, 4, ... columns
  std::size_t pitch_;  ///< of a table's row
  std::size_t words_;  ///< of 64 rows in a list of marks
  Chord* chords_;
  std::uint64_t* falling_;  ///< per block: rows that go beyond the row above them (matter to middles further up)
  std::uint64_t* rising_;   ///< per block: rows that go beyond the row below them (matter to middles further down)
  std::uint8_t* cells_[2];
  const std::uint8_t** left_;
  const std::uint8_t** right_;
  int chord_count_ = 0;
  std::uint8_t* slots_;
};

/// The buffers of all calls. `element` and `rectangles` are those of the last reserve() for an ellipse.
struct MorphologyScratch::Buffers {
  AlignedBytes work;   ///< of a pass
  AlignedBytes plane;  ///< between dilation and erosion, or a copy of the input
  std::vector<Reach> rectangles;
};

}  // namespace adit
