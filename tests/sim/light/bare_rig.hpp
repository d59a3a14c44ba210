// A rig without noise, blur, glare or movement, for laws in closed form.
#pragma once

#include "adit/sim/render.hpp"

namespace adit::sim::test {

/// One lamp in the lens's own place, shining alike into the half-space before it.
inline RigConfig bare_rig(float lux_at_1m = 100.0f) {
  RigConfig rig;
  Lamp lamp;
  lamp.forward_m = 0.0f;
  lamp.lux_at_1m = lux_at_1m;
  lamp.lobe_exponent = 0.0f;
  rig.lamps.lamps = {lamp};
  rig.lamps.tint_red = rig.lamps.tint_blue = 1.0f;
  rig.lens.width = 160;
  rig.lens.height = 120;
  rig.lens.forward_m = 0.0f;
  rig.lens.glare = 0.0f;
  rig.lens.blur_px = 0.0f;
  rig.sensor.readout_s = 0.0f;
  return rig;
}

inline RenderConfig bare_render() {
  RenderConfig render;
  render.threads = 1;
  render.virtual_lights = 0;
  render.facets = false;
  render.sensor_noise = false;
  render.cull_fraction = 0.0f;
  return render;
}

inline Shot shot_at(const Eigen::Vector3f& place) {
  Shot shot;
  shot.pose.place = place;
  return shot;
}

/// Unit direction of a pixel in the body frame of a level vehicle: x forward, y left, z up.
inline Eigen::Vector3f direction_of(const Camera& camera, int u, int v) {
  const NormalisedPoint n = camera.normalised_of({static_cast<double>(u), static_cast<double>(v)});
  return Eigen::Vector3f(1.0f, static_cast<float>(-n.sx), static_cast<float>(-n.sy)).normalized();
}

}  // namespace adit::sim::test
