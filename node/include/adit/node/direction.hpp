// A bearing as an arrow that tools can draw.
#pragma once

#include "adit/camera.hpp"

namespace adit::node {

/// A rotation, as in geometry_msgs/Quaternion.
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// A point at distance 1 in the direction of a bearing, in the optical frame (x right, y down, z forward).
struct Direction {
  double x = 0.0, y = 0.0, z = 1.0;
};
[[nodiscard]] Direction direction_of(const Bearing& bearing) noexcept;

/// The rotation that turns the x axis of the optical frame (along which poses are drawn) into the bearing.
[[nodiscard]] Quaternion arrow_of(const Bearing& bearing) noexcept;

}  // namespace adit::node
