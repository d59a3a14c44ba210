// Frames with a lamp's beam, rock and openings, drawn without a renderer: the same on every machine.
#pragma once

#include <vector>

#include "frames.hpp"

namespace adit::test {

/// A dark place: an ellipse about (u, v), px.
struct DrawnOpening {
  double u_px;
  double v_px;
  double half_width_px;
  double half_height_px;
};

/// Rock in the light of a lamp at the camera.
struct DrawnScene {
  int width = 640;
  int height = 480;
  std::vector<DrawnOpening> openings;
  double beam_px = 600.0;     ///< distance from the middle at which the beam has lost half of its light
  double brightness = 170.0;  ///< grey level of rock in the middle of the beam
  double texture = 0.15;      ///< share by which rock differs from place to place
  double veil = 0.0;          ///< grey level of what dust throws back in the middle of the beam
  int noise = 3;
  unsigned seed = 1;
};
[[nodiscard]] Frame drawn(const DrawnScene& scene);

/// A disc of full white with a halo that falls with the distance.
void add_lamp(Frame& grey, double u_px, double v_px, double radius_px);
/// A dark line across the frame, such as a cable.
void add_cable(Frame& grey, double v_px, double thickness_px);

}  // namespace adit::test
