#include "adit/dark_channel.hpp"

#include <algorithm>

#include "morphology_passes.hpp"

namespace adit {
namespace {

/// Smallest colour channel of a row.
class ChannelMinimum {
 public:
  ChannelMinimum(PixelFormat format, int grey16_depth_bits) noexcept
      : loops_(kernels::pixel_loops()), format_(format), shift_(grey16_depth_bits - 8) {}

  void operator()(const std::uint8_t* from, std::uint8_t* to, int width) const noexcept {
    switch (format_) {
      case PixelFormat::kGrey8:
        std::memcpy(to, from, static_cast<std::size_t>(width));
        return;
      case PixelFormat::kGrey16:
        loops_.grey16_to_8(from, shift_, to, width);
        return;
      case PixelFormat::kBgr8:
      case PixelFormat::kRgb8:
        loops_.triplet_minimum(from, to, width);
        return;
      case PixelFormat::kBgra8:
      case PixelFormat::kRgba8:
        loops_.quad_minimum(from, to, width);
        return;
    }
  }

 private:
  const kernels::PixelLoops& loops_;
  PixelFormat format_;
  int shift_;
};

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
