// What the sensor keeps from frame to frame: sensitivities, fixed pattern, normal variates, tone curve.
#include <algorithm>
#include <cmath>

#include "../light/parts.hpp"
#include "../light/sensor_rows.hpp"
#include "hash.hpp"

namespace adit::sim {
namespace {

/// Quantile of the standard normal by bisection of the error function.
double quantile(double p) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<float> gauss_table() {
  std::vector<double> raw(kGaussSteps);
  double sum2 = 0.0;
  for (std::size_t i = 0; i < kGaussSteps; ++i) {
    raw[i] = quantile((static_cast<double>(i) + 0.5) / kGaussSteps);
    sum2 += raw[i] * raw[i];
  }
  const double scale = 1.0 / std::sqrt(sum2 / kGaussSteps);  // the cut tails back in: variance exactly one
  std::vector<float> table(kGaussSteps);
  for (std::size_t i = 0; i < kGaussSteps; ++i) table[i] = static_cast<float>(raw[i] * scale);
  return table;
}

std::vector<std::int32_t> tone_table(const SensorConfig& sensor) {
  const int top = (1 << sensor.adc_bits) - 1;
  std::vector<std::int32_t> tone(static_cast<std::size_t>(top) + 1);
  for (int i = 0; i <= top; ++i)
    tone[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(
        std::lround(255.0 * std::pow(static_cast<double>(i) / top, 1.0 / static_cast<double>(sensor.gamma))));
  return tone;
}

/// 1 inside the lens's image circle, 0 outside.
float inside_circle(const LensConfig& lens, int u, int v) {
  if (lens.circle_fraction >= 1.2f) return 1.0f;
  const float du = static_cast<float>(u) - 0.5f * static_cast<float>(lens.width - 1);
  const float dv = static_cast<float>(v) - 0.5f * static_cast<float>(lens.height - 1);
  const float half_diagonal = 0.5f * std::hypot(static_cast<float>(lens.width), static_cast<float>(lens.height));
  const float x = std::clamp((lens.circle_fraction + 0.04f - std::hypot(du, dv) / half_diagonal) / 0.08f, 0.0f, 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

}  // namespace

SensorTables sensor_tables_of(const Renderer::Parts& parts) {
  const LensConfig& lens = parts.rig.lens;
  const SensorConfig& s = parts.rig.sensor;
  SensorTables tables;
  tables.gauss = gauss_table();
  tables.tone = tone_table(s);
  const auto count = static_cast<std::size_t>(parts.width) * parts.height;
  tables.sensitivity.resize(count);
  tables.offset_e.resize(count);
  const float gain = electrons_per_luminance_second(lens, s);
  for (int v = 0; v < parts.height; ++v)
    for (int u = 0; u < parts.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * parts.width + u;
      const float cosine = parts.ray_of(u, v).z();
      const float a = tables.gauss[hashed(2 * i + 0x100000001b3ULL) >> 20];
      const float b = tables.gauss[hashed(2 * i + 0x200000001b4ULL) >> 20];
      const float spread = parts.render.sensor_noise ? s.response_spread_fraction * a : 0.0f;
      tables.sensitivity[i] =
          gain * std::pow(cosine, lens.vignetting_exponent) * inside_circle(lens, u, v) * (1.0f + spread);
      tables.offset_e[i] = s.pattern_noise_e * b;
    }
  return tables;
}

}  // namespace adit::sim
