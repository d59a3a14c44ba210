#include "adit/dark_channel.hpp"

#include <algorithm>

#include "channel_minimum.hpp"
#include "morphology_passes.hpp"

namespace adit {
namespace {

// Rows of channel minima are kept in a ring, from which the sweep takes them two by two.
void small_patch(const ImageView& view, const ChannelMinimum& channel_minimum, const StructuringElement& patch,
                 PlaneView out, MorphologyScratch::Buffers& buffers) {
  const Order order = smallest_order();
  const int ring = SweepPass::ring_rows(view.width, patch);
  const int tail = view.width % kernels::pixel_loops().lanes;
  const auto pitch = static_cast<std::ptrdiff_t>(AlignedBytes::rounded_up(static_cast<std::size_t>(view.width)));
  std::uint8_t* minima = buffers.plane.get();
  const std::uint8_t* tails = minima + view.width - tail;
  const auto padding = static_cast<std::size_t>(pitch - view.width);
  SweepPass& pass = buffers.passes[0];
  RowTails tails_out(buffers.tails[1], ring, view.width);
  pass.start(order, view.width, view.height, patch, {minima, pitch, ring - 1, tails, pitch, ring - 1},
             rows_of(out, buffers.tails[1], ring));
  int rows = 0;
  for (int v = 0; v < view.height; v += 2) {
    for (; rows < std::min(view.height, v + 2 + patch.height() / 2); ++rows) {
      std::uint8_t* row = minima + static_cast<std::ptrdiff_t>(rows & (ring - 1)) * pitch;
      channel_minimum(view.row(rows), row, view.width);
      std::memset(row + view.width, order.identity, padding);
    }
    pass.take(v);
    tails_out.give(out, pass.rows_done());
  }
  pass.finish();
  tails_out.give(out, view.height);
}

}  // namespace

void dark_channel(const ImageView& view, const StructuringElement& patch, int grey16_depth_bits, PlaneView out,
                  MorphologyScratch& scratch) noexcept {
  const ChannelMinimum channel_minimum(view.format, grey16_depth_bits);
  if (SweepPass::takes(smallest_order(), patch)) {
    return small_patch(view, channel_minimum, patch, out, scratch.buffers());
  }
  RectanglePass pass(smallest_order(), view.width, view.height, patch, scratch.buffers().work.get());
  for (int v = 0; v < view.height; ++v) {
    channel_minimum(view.row(v), pass.next_row(), view.width);
    pass.advance(out);
  }
  pass.finish(out);
}

}  // namespace adit
