// The smallest colour channel of a row of any pixel format and layout: where every method begins.
#pragma once

#include <cstring>

#include "adit/image.hpp"
#include "kernels/pixel_loops.hpp"
#include "spread_pixels.hpp"

namespace adit {

/// Smallest colour channel of pixels of one row, 8 bits a pixel.
class ChannelMinimum {
 public:
  /// @param view  a frame for which fault_of(view) is empty; it outlives this.
  ChannelMinimum(const ImageView& view, int grey16_depth_bits) noexcept
      : loops_(kernels::pixel_loops()), view_(view), is_packed_(view.is_packed()), shift_(grey16_depth_bits - 8) {}

  /// A whole row.
  void operator()(int v, std::uint8_t* to) const noexcept { (*this)(v, 0, view_.width, to); }

  /// Pixels first to first + count - 1 of row v.
  void operator()(int v, int first, int count, std::uint8_t* to) const noexcept {
    const std::uint8_t* const from = view_.row(v) + first * view_.pixel_step();
    if (!is_packed_) return spread_minimum(view_, from, shift_, to, count);
    switch (view_.format) {
      case PixelFormat::kGrey8:
        std::memcpy(to, from, static_cast<std::size_t>(count));
        return;
      case PixelFormat::kGrey16:
        loops_.grey16_to_8(from, shift_, to, count);
        return;
      case PixelFormat::kBgr8:
      case PixelFormat::kRgb8:
        loops_.triplet_minimum(from, to, count);
        return;
      case PixelFormat::kBgra8:
      case PixelFormat::kRgba8:
        loops_.quad_minimum(from, to, count);
        return;
    }
  }

 private:
  const kernels::PixelLoops& loops_;
  const ImageView& view_;
  bool is_packed_;
  int shift_;
};

}  // namespace adit
