// Pixels that do not lie side by side: mirrored, every second one, planes one after the other.
#pragma once

#include <cstdint>

#include "adit/image.hpp"

namespace adit {

/// The smallest colour channel of pixels in a row; 16-bit grey brought to 8 bits as in dark_channel.hpp.
/// @param from   the first of them. @param shift  grey16_depth_bits - 8.
void spread_minimum(const ImageView& view, const std::uint8_t* from, int shift, std::uint8_t* to, int count) noexcept;

/// Copies pixels of a row side by side, as the format has them; a fourth channel too, if there is one.
/// @param to  count * bytes_per_pixel(view.format) bytes.
void gather_pixels(const ImageView& view, const std::uint8_t* from, std::uint8_t* to, int count) noexcept;

}  // namespace adit
