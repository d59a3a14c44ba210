// The rigs that come with the project.
#include <stdexcept>

#include "adit/sim/render.hpp"
#include "adit/sim/rig_fields.hpp"

namespace adit::sim {
namespace {

/// The paper's vehicle: light bars beside the camera that give 460 lux at 1 m, a PlayStation Eye.
RigConfig flood_460lux() {
  RigConfig rig;
  rig.name = "flood_460lux";
  Lamp bar;
  bar.forward_m = 0.08f;
  bar.lux_at_1m = 230.0f;
  bar.lobe_exponent = 2.0f;
  bar.up_m = -0.05f;
  bar.left_m = 0.18f;
  Lamp other = bar;
  other.left_m = -bar.left_m;
  rig.lamps.lamps = {bar, other};
  return rig;
}

RigConfig dim_40lux() {
  RigConfig rig = flood_460lux();
  rig.name = "dim_40lux";
  for (Lamp& lamp : rig.lamps.lamps) lamp.lux_at_1m = 20.0f;
  return rig;
}

/// A lamp whose beam is narrower than the lens: corners, ceiling and far walls stay black.
RigConfig narrow_beam() {
  RigConfig rig;
  rig.name = "narrow_beam";
  Lamp spot;
  spot.forward_m = 0.05f;
  spot.up_m = 0.12f;
  spot.left_m = 0.10f;
  spot.pitch_deg = -9.0f;
  spot.flux_lm = 700.0f;
  spot.lobe_exponent = 9.0f;
  spot.edge_deg = 24.0f;
  spot.edge_softness_deg = 8.0f;
  spot.spill_fraction = 0.045f;
  Lamp other = spot;
  other.left_m = -spot.left_m;
  rig.lamps.lamps = {spot, other};
  // Greenish LEDs and a white balance that does not take it away.
  rig.lamps.tint_red = 0.80f;
  rig.lamps.tint_blue = 0.62f;
  rig.lens.hfov_deg = 69.0f;
  rig.lens.blur_px = 0.8f;
  rig.lens.vignetting_exponent = 5.0f;
  rig.sensor.exposure_target_level = 62.0f;
  rig.sensor.gain_max = 16.0f;
  rig.sensor.colour_fade_gain = 1000.0f;  // its colours stay in the dark
  rig.sensor.white_blue = 1.75f;
  rig.sensor.jpeg_quality = 80;
  return rig;
}

/// The quadrotor X3 of the DARPA SubT simulator: three flashlights of 1 rad inner and 1.1 rad outer full angle.
RigConfig subt_x3() {
  RigConfig rig;
  rig.name = "subt_x3";
  Lamp right;
  right.forward_m = 0.0f;
  right.left_m = -0.08f;
  right.up_m = 0.05f;
  right.yaw_deg = -17.2f;
  right.pitch_deg = 3.4f;
  right.flux_lm = 350.0f;
  right.lobe_exponent = 1.0f;
  right.edge_deg = 30.0f;
  right.edge_softness_deg = 1.5f;
  Lamp left = right;
  left.left_m = 0.08f;
  left.yaw_deg = 17.2f;
  Lamp down = right;
  down.forward_m = 0.02f;
  down.left_m = 0.0f;
  down.up_m = 0.075f;
  down.yaw_deg = 0.0f;
  down.pitch_deg = -11.5f;
  rig.lamps.lamps = {right, left, down};
  rig.lamps.tint_red = 1.0f;
  rig.lamps.tint_blue = 0.625f;
  rig.lens.forward_m = 0.10f;
  rig.lens.hfov_deg = 110.0f;  // the X3's own 2 rad is 114.6
  return rig;
}

}  // namespace

const std::vector<std::string>& rig_preset_names() {
  static const std::vector<std::string> names = {"flood_460lux", "dim_40lux", "narrow_beam", "subt_x3"};
  return names;
}

RigConfig rig_preset(std::string_view name) {
  if (name == "flood_460lux") return flood_460lux();
  if (name == "dim_40lux") return dim_40lux();
  if (name == "narrow_beam") return narrow_beam();
  if (name == "subt_x3") return subt_x3();
  std::string known;
  for (const std::string& n : rig_preset_names()) known += (known.empty() ? "" : ", ") + n;
  throw std::invalid_argument("rig: there is no '" + std::string(name) + "'; choose one of " + known);
}

namespace {

/// Looks at every field of a struct against its own note.
template <class Config>
void check(const Config& config, const std::string& prefix, std::string& fault) {
  visit_fields(config, [&](const FieldNote& note, const auto& value) {
    const auto v = static_cast<double>(value);
    if (!fault.empty() || (v >= note.minimum * (1 - 1e-6) - 1e-12 && v <= note.maximum * (1 + 1e-6))) return;
    const auto number = [](double x) {
      std::string text = std::to_string(x);
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
      return text;
    };
    fault = prefix + note.name + " is " + number(v) + (*note.unit ? " " : "") + note.unit + "; " +
            number(note.minimum) + " to " + number(note.maximum) + " are possible";
  });
}

}  // namespace

std::string fault_of(const RigConfig& rig) {
  std::string fault;
  if (rig.lamps.lamps.size() > 16)
    return "lamps: there are " + std::to_string(rig.lamps.lamps.size()) + "; at most 16 are possible";
  for (std::size_t i = 0; i < rig.lamps.lamps.size(); ++i)
    check(rig.lamps.lamps[i], "lamps[" + std::to_string(i) + "].", fault);
  check(rig.lamps, "lamps.", fault);
  check(rig.lens, "lens.", fault);
  check(rig.sensor, "sensor.", fault);
  check(rig.dust, "dust.", fault);
  check(rig.dirt, "dirt.", fault);
  return fault;
}

}  // namespace adit::sim
