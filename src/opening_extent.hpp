// The angles that an opening takes up.
#pragma once

#include "adit/finder.hpp"

namespace adit {

/// Half the angles that the box takes up, measured through the opening's own centre.
inline void note_extent(const Camera& camera, Opening& opening) noexcept {
  const Pixel mean = opening.centroid_px;
  const Bearing left = camera.bearing_of({opening.top_left_px.u_px, mean.v_px});
  const Bearing right = camera.bearing_of({opening.bottom_right_px.u_px, mean.v_px});
  const Bearing top = camera.bearing_of({mean.u_px, opening.top_left_px.v_px});
  const Bearing bottom = camera.bearing_of({mean.u_px, opening.bottom_right_px.v_px});
  opening.half_width_rad = 0.5 * (right.azimuth_rad - left.azimuth_rad);
  opening.half_height_rad = 0.5 * (top.elevation_rad - bottom.elevation_rad);
}

}  // namespace adit
