#include <algorithm>

#include "morphology_passes.hpp"

namespace adit {
namespace {

// A chord that reaches past both ends of a row is no longer than the row.
int clipped(int reach, int length) { return std::min(reach, length - 1); }

std::size_t pitch_of(int width, int reach_u) {
  return AlignedBytes::rounded_up(static_cast<std::size_t>(width + 2 * reach_u));
}

}  // namespace

Order smallest_order() noexcept { return {kernels::pixel_loops().smallest, 255}; }
Order largest_order() noexcept { return {kernels::pixel_loops().largest, 0}; }

std::size_t RectanglePass::bytes_needed(int width, int height, const StructuringElement& element) noexcept {
  const int rows = 2 * clipped(element.height() / 2, height) + 1;
  return pitch_of(width, clipped(element.width() / 2, width)) * static_cast<std::size_t>(4 + rows);
}

RectanglePass::RectanglePass(Order order, int width, int height, const StructuringElement& element,
                             std::uint8_t* work) noexcept
    : order_(order),
      width_(width),
      reach_u_(clipped(element.width() / 2, width)),
      reach_v_(clipped(element.height() / 2, height)),
      pitch_(pitch_of(width, reach_u_)),
      source_(work),
      doubled_{work + pitch_, work + 2 * pitch_},
      running_(work + 3 * pitch_),
      block_(work + 4 * pitch_) {
  std::memset(source_, order_.identity, pitch_);
  std::memset(running_, order_.identity, pitch_);
  // Rows above the plane: they fill the head of the first block and never win.
  std::memset(block_, order_.identity, static_cast<std::size_t>(reach_v_) * pitch_);
  row_in_block_ = reach_v_;
}

// Windows of 1, 2, 4, ... columns, each from two of the last; the final width is made of two that overlap.
void RectanglePass::window_of_row(std::uint8_t* to) noexcept {
  const int window = 2 * reach_u_ + 1;
  const std::uint8_t* from = source_;
  int length = width_ + 2 * reach_u_;
  int columns = 1;
  for (int turn = 0; 2 * columns <= window; turn ^= 1, columns *= 2) {
    length -= columns;
    order_.loops.join(from, from + columns, doubled_[turn], length);
    from = doubled_[turn];
  }
  order_.loops.join(from, from + window - columns, to, width_);
}

void RectanglePass::close_block() noexcept {
  const int rows = 2 * reach_v_ + 1;
  for (int i = rows - 2; i >= 0; --i) {
    std::uint8_t* row = block_ + static_cast<std::size_t>(i) * pitch_;
    order_.loops.join(row, row + pitch_, row, width_);
  }
  std::memset(running_, order_.identity, static_cast<std::size_t>(width_));
  row_in_block_ = 0;
}

void RectanglePass::advance(PlaneView out, bool past_the_end) noexcept {
  const int rows = 2 * reach_v_ + 1;
  // Row i of the block is read for the last time one step before it is written again: one block is enough.
  std::uint8_t* row = block_ + static_cast<std::size_t>(row_in_block_) * pitch_;
  if (past_the_end) {
    std::memset(row, order_.identity, static_cast<std::size_t>(width_));
  } else {
    window_of_row(row);
  }
  ++rows_in_;
  if (rows_in_ <= reach_v_) {  // no window is complete yet
    order_.loops.join(row, running_, running_, width_);
  } else if (row_in_block_ + 1 == rows) {
    order_.loops.fold(row, running_, row, out.row(rows_out_++), width_);
  } else {
    order_.loops.fold(row, running_, row + pitch_, out.row(rows_out_++), width_);
  }
  if (++row_in_block_ == rows) close_block();
}

}  // namespace adit
