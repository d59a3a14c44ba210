#include "adit/dark_channel.hpp"

#include "channel_minimum.hpp"
#include "rectangle_pass.hpp"

namespace adit {

void dark_channel(const ImageView& view, const StructuringElement& patch, int grey16_depth_bits, PlaneView out,
                  MorphologyScratch& scratch) noexcept {
  const ChannelMinimum channel_minimum(view, grey16_depth_bits);
  MorphologyScratch::Buffers& buffers = scratch.buffers();
  if (RectanglePass::takes(patch)) {
    RectanglePass pass(smallest_order(), view.width, view.height, patch, buffers.work.get());
    for (int v = 0; v < view.height; ++v) {
      channel_minimum(v, pass.next_row());
      pass.advance(out);
    }
    return pass.finish(out);
  }
  const auto fill = [&](int v, int rows, int first, int count, kernels::Rows to) {
    for (; rows > 0; --rows, ++v, to.first += to.pitch) {
      channel_minimum(v, first, count, to.first);
    }
  };
  BandPass(smallest_order(), buffers.plans_for(view.width, patch).alone, view.height, buffers.work.get())
      .run(fill, out);
}

}  // namespace adit
