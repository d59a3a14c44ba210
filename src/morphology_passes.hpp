// How a flat element is applied to a plane. Three ways, all exact; which is fastest depends on the element's size.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
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

/// Rows in memory: of a plane, or of a ring that holds the last few. A row is whole vectors, and a tail where the width
/// is no multiple of a vector: that vector lies apart, filled up with what is never better.
template <class Byte>
struct Rows {
  Byte* first = nullptr;
  std::ptrdiff_t stride = 0;
  int mask = -1;  ///< of the row's number; -1: all rows are there
  Byte* tails = nullptr;
  std::ptrdiff_t tail_stride = 0;
  int tail_mask = -1;

  [[nodiscard]] Byte* row(int v) const noexcept { return first + static_cast<std::ptrdiff_t>(v & mask) * stride; }
  [[nodiscard]] Byte* tail(int v) const noexcept {
    return tails + static_cast<std::ptrdiff_t>(v & tail_mask) * tail_stride;
  }
};

/// The best value over a small round or square element, in pairs of rows, handed in from the top to the bottom. Results
/// are late by a few vectors, so that a pair may be complete only after the next ones have been taken.
class SweepPass {
 public:
  /// Pairs that go through the loop together.
  static constexpr int kBatch = 4;

  /// Whether there may be a target that sweeps over this element.
  [[nodiscard]] static bool fits(const StructuringElement& element) noexcept;
  /// Whether the present one does.
  [[nodiscard]] static bool takes(const Order& order, const StructuringElement& element) noexcept;

  /// Makes room. May throw std::bad_alloc.
  void reserve(int width, const StructuringElement& element);
  void start(Order order, int width, int height, const StructuringElement& element, Rows<const std::uint8_t> in,
             Rows<std::uint8_t> out) noexcept;

  /// Takes rows v and v + 1; the rows up to v + 1 + reach must be there.
  void take(int v) noexcept;
  /// Works off what was taken.
  void run() noexcept;
  /// Works off all, after the last row.
  void finish() noexcept;
  /// Rows that are complete. Rows of the pairs before, from rows_done() - reach on, are still read.
  [[nodiscard]] int rows_done() const noexcept { return rows_done_; }

  /// Rows that a ring must have between two passes, or for the tails of a plane.
  [[nodiscard]] static int ring_rows(int width, const StructuringElement& element) noexcept;

 private:
  void lay_out_places() noexcept;
  void list_rows(int v, const std::uint8_t** rows, bool tails) const noexcept;
  void sweep(const kernels::SweepPlace* places, int count) noexcept;

  kernels::SweepLoop loop_ = nullptr;
  int lanes_ = 1;
  int body_ = 0;  ///< columns of a row's whole vectors
  int tail_ = 0;  ///< columns of its tail
  int height_ = 0;
  int reach_ = 0;
  int lag_ = 0;          ///< places by which results are late
  int pair_places_ = 1;  ///< places of a pair of rows
  int slots_ = 0;        ///< for pairs, used in turn: those on their way stay
  int first_slot_ = 0;   ///< of the pairs taken, but not yet worked off
  int next_slot_ = 0;
  int rows_done_ = 0;
  std::int64_t places_done_ = 0;
  Rows<const std::uint8_t> in_;
  Rows<std::uint8_t> out_;
  AlignedBytes state_;
  AlignedBytes gap_;      ///< one vector that is never better
  AlignedBytes nowhere_;  ///< a row to write to that nobody reads
  std::vector<kernels::SweepPlace> places_;
  std::vector<kernels::SweepPair> pairs_;  ///< of a slot: its whole vectors, its tail
  std::vector<const std::uint8_t*> row_lists_;
  std::vector<const std::uint8_t*> gap_rows_;
  kernels::SweepPair gap_pair_;
};

/// The rows of a plane, and copies of their tails in a ring.
template <class Plane>
auto rows_of(Plane plane, AlignedBytes& tails, int ring_rows) {
  using Byte = std::remove_pointer_t<decltype(plane.data)>;
  return Rows<Byte>{.first = plane.data,
                    .stride = plane.stride_bytes,
                    .tails = tails.get(),
                    .tail_stride = AlignedBytes::kAlignment,
                    .tail_mask = ring_rows - 1};
}

/// Copies tails of a plane's rows into the ring as they are needed, filled up with what is never better; or out of it.
class RowTails {
 public:
  RowTails(AlignedBytes& ring, int ring_rows, int width) noexcept
      : ring_(ring.get()), mask_(ring_rows - 1), tail_(width % kernels::pixel_loops().lanes), body_(width - tail_) {}

  void fill(std::uint8_t identity) noexcept {
    std::memset(ring_, identity, (static_cast<std::size_t>(mask_) + 1) * AlignedBytes::kAlignment);
  }
  void take(ConstPlaneView plane, int end) noexcept {
    for (; tail_ > 0 && done_ < std::min(end, plane.height); ++done_) {
      std::memcpy(of(done_), plane.row(done_) + body_, static_cast<std::size_t>(tail_));
    }
  }
  void give(PlaneView plane, int end) noexcept {
    for (; tail_ > 0 && done_ < end; ++done_) {
      std::memcpy(plane.row(done_) + body_, of(done_), static_cast<std::size_t>(tail_));
    }
  }

 private:
  [[nodiscard]] std::uint8_t* of(int v) const noexcept {
    return ring_ + static_cast<std::size_t>(v & mask_) * AlignedBytes::kAlignment;
  }
  std::uint8_t* ring_;
  int mask_;
  int tail_;
  int body_;
  int done_ = 0;
};

/// The best value over an element of many rows. Strips of columns; chords of each row come from tables of windows of
/// 1, 2, 4, ... columns; and a row is looked at only where it can matter: seen from the element's middle, a row that
/// nowhere goes beyond its inner neighbour is covered by that neighbour's longer chord.
class LargeEllipse {
 public:
  [[nodiscard]] static std::size_t bytes_needed(int height, const StructuringElement& element) noexcept;

  LargeEllipse(Order order, int height, const StructuringElement& element, std::uint8_t* work) noexcept;
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
  void make_row(int v, int height, int width, std::uint8_t* out) noexcept;
  void add_marked(const std::uint64_t* marks, int first, int last, int v, int x) noexcept;
  [[nodiscard]] std::uint8_t* slot(int v) const noexcept;

  Order order_;
  const StructuringElement& element_;
  int reach_v_;
  int ring_;           ///< rows kept, a power of two
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

/// The buffers of all calls.
struct MorphologyScratch::Buffers {
  AlignedBytes work;      ///< of a pass
  AlignedBytes plane;     ///< between dilation and erosion, or a copy of the input
  AlignedBytes tails[2];  ///< of the rows that come in and go out
  SweepPass passes[2];
};

}  // namespace adit
