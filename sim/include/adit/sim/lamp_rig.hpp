// The lamps a robot carries: where they sit, where they shine, how much.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace adit::sim {

/// One lamp fixed to the vehicle. Its luminous intensity at an angle t from its axis is
/// I0 * [(1 - spill_fraction) * cos(t)^lobe_exponent * edge(t) + spill_fraction * cos(t)], where edge falls smoothly
/// from 1 to 0 about edge_deg. I0 follows from lux_at_1m or, where that is 0, from flux_lm.
struct Lamp {
  float forward_m = 0.05f;  ///< place in the body frame
  float left_m = 0.0f;
  float up_m = 0.0f;
  float yaw_deg = 0.0f;    ///< of the axis, positive to the left
  float pitch_deg = 0.0f;  ///< of the axis, positive up
  float lux_at_1m = 0.0f;  ///< illuminance on the axis at 1 m; 0: flux_lm counts
  float flux_lm = 800.0f;
  float lobe_exponent = 1.5f;
  float edge_deg = 90.0f;          ///< half-angle where the reflector or lens cuts the beam; 90: it does not
  float edge_softness_deg = 8.0f;  ///< half the width of that edge
  float spill_fraction = 0.0f;
};

/// All lamps share one colour.
struct LampRig {
  std::vector<Lamp> lamps = {Lamp{}};
  float tint_red = 0.95f;   ///< red light relative to green, as the sensor sees it
  float tint_blue = 1.05f;  ///< blue light relative to green
  bool flash = false;       ///< on in even frames, off in odd ones
};

/// The lobe of a lamp as a function of sin(t/2), ready for look-up.
class LampLobe {
 public:
  static constexpr int kSteps = 512;  ///< over sin(t/2) in [0, 1]

  /// @param edge_deg >= 90 for none.
  LampLobe(float exponent, float edge_deg, float edge_softness_deg, float spill_fraction);
  explicit LampLobe(const Lamp& lamp)
      : LampLobe(lamp.lobe_exponent, lamp.edge_deg, lamp.edge_softness_deg, lamp.spill_fraction) {}

  /// Intensity relative to the axis, [0, 1], for the cosine of the angle to the axis.
  [[nodiscard]] float at(float cosine) const noexcept;
  /// Integral over the sphere, sr: flux = intensity_on_axis * solid_angle_sr.
  [[nodiscard]] float solid_angle_sr() const noexcept { return solid_angle_sr_; }
  /// kSteps + 2 values, linear between them.
  [[nodiscard]] const float* table() const noexcept { return table_.data(); }

 private:
  std::array<float, kSteps + 2> table_{};
  float solid_angle_sr_ = 0.0f;
};

/// Luminous intensity on the axis, cd.
[[nodiscard]] float intensity_on_axis_cd(const Lamp& lamp);

}  // namespace adit::sim
