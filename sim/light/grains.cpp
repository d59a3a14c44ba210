// Grains of dust near the lens, drawn one by one as discs out of focus, as long as they move within the exposure.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
constexpr float kCell_m = 0.25f;
constexpr float kReach_m = 1.25f;

std::uint32_t hashed(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}
float unit(std::uint32_t h) { return static_cast<float>(h >> 8) * (1.0f / 16777216.0f); }

/// A disc of one luminance drawn from one place to another.
void draw_streak(Renderer::Parts& parts, Pixel from, Pixel to, float radius, float luminance) {
  const auto au = static_cast<float>(from.u_px), av = static_cast<float>(from.v_px);
  const float bu = static_cast<float>(to.u_px) - au, bv = static_cast<float>(to.v_px) - av;
  const float length2 = bu * bu + bv * bv;
  const float spread = std::numbers::pi_v<float> * radius * radius /
                       (std::numbers::pi_v<float> * radius * radius + 2.0f * radius * std::sqrt(length2));
  const float value = luminance * spread;
  const int u_from = std::max(0, static_cast<int>(std::min(au, au + bu) - radius - 1.0f));
  const int u_to = std::min(parts.width - 1, static_cast<int>(std::max(au, au + bu) + radius + 2.0f));
  const int v_from = std::max(0, static_cast<int>(std::min(av, av + bv) - radius - 1.0f));
  const int v_to = std::min(parts.height - 1, static_cast<int>(std::max(av, av + bv) + radius + 2.0f));
  const LampRig& lamps = parts.rig.lamps;
  for (int v = v_from; v <= v_to; ++v)
    for (int u = u_from; u <= u_to; ++u) {
      const float pu = static_cast<float>(u) - au, pv = static_cast<float>(v) - av;
      const float k = length2 > 0.0f ? std::clamp((pu * bu + pv * bv) / length2, 0.0f, 1.0f) : 0.0f;
      const float du = pu - k * bu, dv = pv - k * bv;
      const float cover = std::clamp(radius + 0.5f - std::sqrt(du * du + dv * dv), 0.0f, 1.0f);
      if (cover <= 0.0f) continue;
      const std::size_t at = static_cast<std::size_t>(v) * parts.stride + u;
      parts.planes[0][at] += cover * value * lamps.tint_red;
      parts.planes[1][at] += cover * value;
      parts.planes[2][at] += cover * value * lamps.tint_blue;
    }
}

void draw_grain(Renderer::Parts& parts, const CameraMotion& motion, const Vector3f& p, const Vector3f& drift,
                float time_s) {
  const DustConfig& dust = parts.rig.dust;
  const LensConfig& lens = parts.rig.lens;
  float lux = 0.0f;
  for (const OwnLamp& lamp : parts.own_lamps) {
    const Vector3f way = p - lamp.place;
    const float d2 = std::max(way.squaredNorm(), 1e-4f);
    lux += lamp.intensity_cd * lamp.lobe.at(way.dot(lamp.axis) / std::sqrt(d2)) / d2;
  }
  // A grain much larger than the wavelength, seen from the lit side: a Lambert sphere of reflectance 0.3 sends
  // 2 / (3 pi) of what it reflects back into a steradian.
  constexpr float kReflectance = 0.3f;
  const float diameter = 1e-3f * dust.grain_diameter_mm;
  const float area = 0.25f * std::numbers::pi_v<float> * diameter * diameter;
  const float intensity = lux * area * kReflectance * 2.0f / (3.0f * std::numbers::pi_v<float>);
  const auto focal_px = static_cast<float>(parts.camera->model().focal_length_x_px);
  const float focal_m = focal_px * 1e-6f * parts.rig.sensor.pixel_pitch_um * 640.0f / static_cast<float>(parts.width);
  const float blur_px = 0.5f * focal_m / lens.f_number * std::abs(1.0f / p.z() - 1.0f / lens.focus_m) * focal_px;
  const float radius = std::clamp(std::sqrt(blur_px * blur_px + 0.6f), 0.8f, 60.0f);
  const float solid_angle = std::numbers::pi_v<float> * radius * radius * parts.pixel_angle * parts.pixel_angle;
  const float luminance = intensity / (p.squaredNorm() * solid_angle);
  if (luminance < 1e-3f * motion.white_luminance) return;
  const auto seen_at = [&](float t) {
    const Vector3f q = p + t * (drift - motion.velocity_m_s - motion.turn_rate_rad_s.cross(p));
    const float z = std::max(q.z(), 0.03f);
    return parts.camera->pixel_of(
        NormalisedPoint{std::clamp(q.x() / z, -4.0f, 4.0f), std::clamp(q.y() / z, -4.0f, 4.0f)});
  };
  draw_streak(parts, seen_at(-0.5f * time_s), seen_at(0.5f * time_s), radius, luminance);
}

}  // namespace

void grains_pass(Renderer::Parts& parts, const CameraMotion& motion, const Shot& shot) {
  const DustConfig& dust = parts.rig.dust;
  if (dust.grains_per_m3 <= 0.0f || parts.own_lamps.empty() || !parts.lamps_on) return;
  // The air drifts as a whole through the world; grains have fixed places in it, by cell.
  const Vector3f drift = dust.grain_drift_m_s * Vector3f(0.89f, 0.36f, -0.28f);
  const Vector3f gone = drift * static_cast<float>(shot.time_s);
  const Vector3f eye = motion.pose.translation() - gone;
  const Eigen::Matrix3f to_camera = motion.pose.linear().transpose();
  const float expected = dust.grains_per_m3 * kCell_m * kCell_m * kCell_m;
  const auto cell_of = [](float x) { return static_cast<int>(std::floor(x / kCell_m)); };
  Eigen::Vector3i low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = cell_of(eye[k] - kReach_m);
    high[k] = cell_of(eye[k] + kReach_m);
  }
  for (int i = low.x(); i <= high.x(); ++i)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int k = low.z(); k <= high.z(); ++k) {
        std::uint32_t h = hashed(static_cast<std::uint32_t>(i) * 73856093u ^ static_cast<std::uint32_t>(j) * 19349663u ^
                                 static_cast<std::uint32_t>(k) * 83492791u);
        const int count = std::min(64, static_cast<int>(expected + unit(h)));
        for (int n = 0; n < count; ++n) {
          Vector3f p;
          const int cell[3] = {i, j, k};
          for (int c = 0; c < 3; ++c) {
            h = hashed(h + 0x9e3779b9u);
            p[c] = (static_cast<float>(cell[c]) + unit(h)) * kCell_m;
          }
          const Vector3f q = to_camera * (p - eye);
          if (q.z() > 0.06f && q.norm() < kReach_m && q.head<2>().norm() < 2.0f * q.z())
            draw_grain(parts, motion, q, to_camera * drift, shot.exposure.time_s);
        }
      }
}

}  // namespace adit::sim
