// Atmospheric light, transmission and scattering depth (paper, eq. 1 to 3).
//
// Polarity: black gives transmission 1 and depth 0. In a tunnel lit by the vehicle's own lamp the *smallest*
// scattering depth is the *farthest* place. It has no metric meaning: never publish it as a depth image (REP 118).
#pragma once

#include <array>

#include "adit/api.hpp"
#include "adit/image.hpp"

namespace ADIT_API adit {

/// The scalar `a` of eq. (1), after He et al. (2011), section 4.4: the mean brightness, in grey levels, of the pixels
/// whose dark channel is among the brightest `fraction` of the frame. Pixels that tie with the last of them are all
/// counted, so the answer does not depend on the order of the pixels. Brightness is the mean of the colour channels.
/// @param view      the frame the dark channel came from.
/// @param dark      its dark channel, the same size.
/// @param fraction  in (0, 1]; at least one pixel is taken.
/// @return 0 to 255.
[[nodiscard]] double atmospheric_light(const ImageView& view, int grey16_depth_bits, ConstPlaneView dark,
                                       double fraction) noexcept;

/// One value for each grey level of the dark channel.
using LevelTable = std::array<double, 256>;

/// Eq. (3): transmission t = 1 - omega * level / a for each level, not below transmission_min.
/// With a = 0 (a black frame) every level has transmission 1.
[[nodiscard]] LevelTable transmission_table(double atmospheric_light, double omega, double transmission_min) noexcept;

/// Eq. (2): scattering depth d = -ln(t) / beta for each level. Unitless, >= 0, never falling with the level:
/// because of that the closing of d is d of the closing, and everything up to here stays in 8 bits.
[[nodiscard]] LevelTable scattering_depth_table(const LevelTable& transmission, double scattering_coefficient) noexcept;

}  // namespace adit
