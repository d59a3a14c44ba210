// The frame that `adit bench` takes when it is given none: data/tunnel.jpg, kept in the program.
#pragma once

#include <cstdint>
#include <span>

namespace adit::tools {

/// The bytes of the JPEG file: 640 x 480 px, colour.
[[nodiscard]] std::span<const std::uint8_t> drawn_frame();

}  // namespace adit::tools
