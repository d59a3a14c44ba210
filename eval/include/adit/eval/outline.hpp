// A marked opening: a closed outline in the image.
#pragma once

#include <vector>

#include "adit/camera.hpp"

namespace adit::eval {

/// A polygon in pixels, at least three corners, closed by itself. A box is a polygon of four.
struct Outline {
  std::vector<Pixel> corners;
};

/// The box between two opposite corners, in any order.
[[nodiscard]] Outline box_of(Pixel a, Pixel b);

/// Inside by the even-odd rule; the edge itself counts as inside.
[[nodiscard]] bool contains(const Outline& outline, Pixel place) noexcept;

/// The place itself when it is inside, else the nearest place on the edge, in pixels. The outline has corners.
[[nodiscard]] Pixel nearest_of(const Outline& outline, Pixel place) noexcept;

}  // namespace adit::eval
