// The smallest colour channel of a row of any pixel format: where every method begins.
#pragma once

#include <cstring>

#include "adit/image.hpp"
#include "kernels/pixel_loops.hpp"

namespace adit {

/// Smallest colour channel of a row, 8 bits a pixel.
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

}  // namespace adit
