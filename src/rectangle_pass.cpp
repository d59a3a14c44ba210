#include "rectangle_pass.hpp"

#include <algorithm>

namespace adit {
namespace {

void join(const Order& order, const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out, int width) {
  const kernels::ConstRows from[] = {{a, 0}, {b, 0}};
  order.loops.best_of_rows(from, 2, {out, 0}, width, 1);
}

// A chord that reaches past both ends of a row is no longer than the row.
int clipped(int reach, int length) { return std::min(reach, length - 1); }

std::size_t pitch_of(int width, int reach_u) {
  return AlignedBytes::rounded_up(static_cast<std::size_t>(width + 2 * reach_u));
}

/// Bytes from one row of windows to the next. They are made from each other in turns, and loads are held up by stores
/// under way whose addresses are the same but for multiples of the period: half a period away none is.
std::size_t spacing_of(std::size_t batch_bytes) {
  constexpr std::size_t kPeriod = BandPlan::kAliasPeriod;
  return (batch_bytes + kPeriod / 2 - 1) / kPeriod * kPeriod + kPeriod / 2;
}

}  // namespace

std::size_t RectanglePass::bytes_needed(int width, int height, const StructuringElement& element) noexcept {
  const int rows = 2 * clipped(element.height() / 2, height) + 1;
  const std::size_t pitch = pitch_of(width, clipped(element.width() / 2, width));
  return 3 * spacing_of(batch_of(pitch) * pitch) + pitch * (1 + static_cast<std::size_t>(rows));
}

RectanglePass::RectanglePass(Order order, int width, int height, const StructuringElement& element,
                             std::uint8_t* work) noexcept
    : order_(order),
      width_(width),
      height_(height),
      reach_u_(clipped(element.width() / 2, width)),
      reach_v_(clipped(element.height() / 2, height)),
      pitch_(pitch_of(width, reach_u_)),
      batch_(batch_of(pitch_)),
      source_(work),
      doubled_{work + spacing_of(batch_ * pitch_), work + 2 * spacing_of(batch_ * pitch_)},
      running_(work + 3 * spacing_of(batch_ * pitch_)),
      block_(running_ + pitch_) {
  std::memset(source_, order_.identity, batch_ * pitch_);
  std::memset(running_, order_.identity, pitch_);
  // Rows above the plane: they fill the head of the first block and never win.
  std::memset(block_, order_.identity, static_cast<std::size_t>(reach_v_) * pitch_);
  row_in_block_ = reach_v_;
}

void RectanglePass::advance(PlaneView out) noexcept {
  if (++pending_ == batch_) take_pending(out);
}

void RectanglePass::finish(PlaneView out) noexcept {
  take_pending(out);
  while (rows_out_ < height_) {  // rows below the plane: they never win
    std::memset(row_of_block(), order_.identity, static_cast<std::size_t>(width_));
    take_into_block(row_of_block(), out);
  }
}

// Windows of 1, 2, 4, ... columns, each from two of the last; the final width is made of two that overlap. The rows lie
// one behind the other and are doubled as one: what runs over from a row's end into the next is not used.
void RectanglePass::take_pending(PlaneView out) noexcept {
  const int window = 2 * reach_u_ + 1;
  const std::uint8_t* from = source_;
  int length = static_cast<int>(pending_ * pitch_);
  int columns = 1;
  for (int turn = 0; 2 * columns <= window && length > 0; turn ^= 1, columns *= 2) {
    length -= columns;
    join(order_, from, from + columns, doubled_[turn], length);
    from = doubled_[turn];
  }
  for (std::size_t i = 0; i < pending_; ++i, from += pitch_) {
    join(order_, from, from + window - columns, row_of_block(), width_);
    take_into_block(row_of_block(), out);
  }
  pending_ = 0;
}

// Row i of the block is read for the last time one step before it is written again: one block is enough.
void RectanglePass::take_into_block(std::uint8_t* row, PlaneView out) noexcept {
  const int rows = 2 * reach_v_ + 1;
  ++rows_in_;
  if (rows_in_ <= reach_v_) {  // no window is complete yet
    join(order_, row, running_, running_, width_);
  } else {
    const std::uint8_t* suffix = row_in_block_ + 1 == rows ? row : row + pitch_;
    const std::uint8_t* next = out.row(std::min(rows_out_ + 1, height_ - 1));
    order_.loops.fold(row, running_, suffix, out.row(rows_out_++), next, width_);
  }
  if (++row_in_block_ == rows) close_block();
}

void RectanglePass::close_block() noexcept {
  const int rows = 2 * reach_v_ + 1;
  for (int i = rows - 2; i >= 0; --i) {
    std::uint8_t* row = block_ + static_cast<std::size_t>(i) * pitch_;
    join(order_, row, row + pitch_, row, width_);
  }
  std::memset(running_, order_.identity, static_cast<std::size_t>(width_));
  row_in_block_ = 0;
}

}  // namespace adit
