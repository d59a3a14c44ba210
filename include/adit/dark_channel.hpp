// The dark channel (paper, eq. 3): the smallest value over colour and over a patch.
#pragma once

#include "adit/api.hpp"
#include "adit/image.hpp"
#include "adit/morphology.hpp"

namespace ADIT_API adit {

/// dark(u, v) = min over the colour channels and over the patch centred on (u, v), in grey levels (0 to 255).
/// Pixels outside the frame take no part. Alpha takes no part. 16-bit grey is first brought to 8 bits:
/// min(value >> (grey16_depth_bits - 8), 255).
/// @param view   a frame for which fault_of(view) is empty.
/// @param patch  StructuringElement::rectangle(size, size); the scratch is reserved for it.
/// @param grey16_depth_bits  8 to 16; looked at only for kGrey16.
/// @param out    a plane of the frame's size.
void dark_channel(const ImageView& view, const StructuringElement& patch, int grey16_depth_bits, PlaneView out,
                  MorphologyScratch& scratch) noexcept;

}  // namespace adit
