#include <algorithm>
#include <cmath>

#include "adit/sim/sensor.hpp"

namespace adit::sim {

AutoExposure::AutoExposure(const SensorConfig& sensor, Exposure start) : sensor_(sensor), current_(start) {
  current_.time_s = std::clamp(current_.time_s, sensor_.exposure_min_s, sensor_.exposure_max_s);
  current_.gain = std::clamp(current_.gain, 1.0f, sensor_.gain_max);
}

void AutoExposure::observe(float mean_level) noexcept {
  // Levels are light to the power of 1 / gamma. At most two stops a frame, as saturated or black frames say no more.
  const float ratio = sensor_.exposure_target_level / std::max(mean_level, 0.5f);
  const float step = std::clamp(std::pow(ratio, sensor_.gamma), 0.25f, 4.0f);
  const float product = current_.time_s * current_.gain * std::pow(step, sensor_.exposure_speed);
  current_.time_s = std::clamp(product, sensor_.exposure_min_s, sensor_.exposure_max_s);
  current_.gain = std::clamp(product / current_.time_s, 1.0f, sensor_.gain_max);
}

CameraModel camera_model(const LensConfig& lens) {
  CameraModel model = pinhole(lens.width, lens.height, static_cast<double>(lens.hfov_deg));
  if (lens.k1 != 0.0f || lens.k2 != 0.0f || lens.p1 != 0.0f || lens.p2 != 0.0f || lens.k3 != 0.0f) {
    model.distortion_model = DistortionModel::kPlumbBob;
    model.distortion = {static_cast<double>(lens.k1), static_cast<double>(lens.k2), static_cast<double>(lens.p1),
                        static_cast<double>(lens.p2), static_cast<double>(lens.k3)};
  }
  return model;
}

float electrons_per_luminance_second(const LensConfig& lens, const SensorConfig& sensor) {
  constexpr double kPhotonsPerLumenSecond = 4.09e15;  // 1 / (683 lm/W * h c / 555 nm)
  const double lux = 0.25 * 3.14159265 * static_cast<double>(lens.transmission) /
                     (static_cast<double>(lens.f_number) * static_cast<double>(lens.f_number));
  const double pitch_m = 1e-6 * static_cast<double>(sensor.pixel_pitch_um);
  return static_cast<float>(lux * kPhotonsPerLumenSecond * pitch_m * pitch_m *
                            static_cast<double>(sensor.quantum_efficiency));
}

}  // namespace adit::sim
