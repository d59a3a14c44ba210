#include <algorithm>
#include <cmath>
#include <numbers>

#include "adit/sim/lamp_rig.hpp"

namespace adit::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// 1 inside, 0 outside, smooth between edge - softness and edge + softness.
double edge(double angle_deg, double edge_deg, double softness_deg) {
  if (edge_deg >= 90.0) return 1.0;
  const double x = std::clamp((edge_deg + softness_deg - angle_deg) / std::max(2.0 * softness_deg, 1e-6), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

LampLobe::LampLobe(float exponent, float edge_deg, float edge_softness_deg, float spill_fraction) {
  const auto intensity = [&](double angle) {
    const double cosine = std::cos(angle);
    // An exponent of 0 shines into all directions; any other lobe ends at the lamp's own plane.
    if (cosine <= 0.0) return exponent == 0.0f && edge_deg >= 90.0f ? 1.0 - spill_fraction : 0.0;
    return (1.0 - spill_fraction) * std::pow(cosine, exponent) * edge(angle / kDegree, edge_deg, edge_softness_deg) +
           spill_fraction * cosine;
  };
  double previous_angle = 0.0, sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = 2.0 * std::asin(static_cast<double>(i) / kSteps);
    table_[static_cast<std::size_t>(i)] = static_cast<float>(intensity(angle));
    // Simpson's rule within each step.
    const double middle = 0.5 * (previous_angle + angle);
    sum += (angle - previous_angle) / 6.0 *
           (intensity(previous_angle) * std::sin(previous_angle) + 4.0 * intensity(middle) * std::sin(middle) +
            intensity(angle) * std::sin(angle));
    previous_angle = angle;
  }
  table_[kSteps + 1] = table_[kSteps];
  solid_angle_sr_ = static_cast<float>(2.0 * std::numbers::pi * sum);
}

float LampLobe::at(float cosine) const noexcept {
  const float step = std::sqrt(std::clamp(0.5f - 0.5f * cosine, 0.0f, 1.0f)) * kSteps;
  const auto k = static_cast<std::size_t>(step);
  return table_[k] + (step - static_cast<float>(k)) * (table_[k + 1] - table_[k]);
}

float intensity_on_axis_cd(const Lamp& lamp) {
  if (lamp.lux_at_1m > 0.0f) return lamp.lux_at_1m;
  return lamp.flux_lm / LampLobe(lamp).solid_angle_sr();
}

}  // namespace adit::sim
