// The lens: from a point of the plane z = 1 to where the lens puts it, and back. Internal to Camera.
#pragma once

#include "adit/camera.hpp"

namespace adit {

/// Where the lens puts a point. Equidistant: `point` is theta * (cos, sin), any angle; else it is on the plane z = 1.
[[nodiscard]] NormalisedPoint distorted(const CameraModel& model, NormalisedPoint point) noexcept;

/// The largest radius up to which the model's radius grows; at most that of 89 deg (equidistant: pi).
[[nodiscard]] double growing_radius_max(const CameraModel& model) noexcept;

/// The inverse of distorted(), in the same coordinates. Finite for any finite point; on the circle of radius_max where
/// there is no inverse.
[[nodiscard]] NormalisedPoint undistorted(const CameraModel& model, double radius_max, NormalisedPoint seen) noexcept;

}  // namespace adit
