// What happens between rock and sensor besides light and dust: haze about foreign lamps, the lamps themselves, motion
// blur, glare.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "adit/sim/dust.hpp"
#include "blur_row.hpp"
#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
constexpr int kHazeBlock_px = 8;

/// Single scattering of one lamp along a ray, with equi-angular steps (Kulla and Fajardo 2012): they crowd where the
/// ray passes the lamp.
float haze_along(const ForeignLamp& lamp, const DustConfig& dust, const Vector3f& eye, const Vector3f& view,
                 float range_m) {
  constexpr int kSteps = 12;
  const float along = view.dot(lamp.place - eye);
  const Vector3f foot = eye + view * along;
  const float h = std::max((lamp.place - foot).norm(), lamp.radius_m);
  const float a = std::atan2(-along, h), b = std::atan2(std::min(range_m, 200.0f) - along, h);
  float sum = 0.0f;
  for (int i = 0; i < kSteps; ++i) {
    const float angle = a + (b - a) * (static_cast<float>(i) + 0.5f) / kSteps;
    const float s = along + h * std::tan(angle);
    const Vector3f way = eye + view * s - lamp.place;
    const float d = std::max(way.norm(), lamp.radius_m);
    const float lobe = lamp.lobe.at(way.dot(lamp.axis) / d);
    // ds / d^2 = dangle / h, so that the inverse square drops out.
    sum += lobe * henyey_greenstein(-way.dot(view) / d, dust.asymmetry) * std::exp(-dust.extinction_1_m * (d + s));
  }
  return lamp.intensity_cd * dust.extinction_1_m * dust.scattering_albedo * sum * (b - a) / (kSteps * h);
}

/// Haze of all foreign lamps on a coarse grid, then added between its nodes.
void add_foreign_haze(Renderer::Parts& parts, const CameraMotion& motion) {
  const DustConfig& dust = parts.rig.dust;
  if (dust.extinction_1_m <= 0.0f || parts.foreign_lamps.empty()) return;
  const int across = parts.stride / kHazeBlock_px, down = parts.rows / kHazeBlock_px;
  std::vector<float> haze(static_cast<std::size_t>(across) * down), day(haze.size());
  const Vector3f eye = motion.pose.translation();
  const float least = 0.5f * parts.render.cull_fraction * motion.white_luminance;
  parts.each(down, [&](int j) {
    for (int i = 0; i < across; ++i) {
      const std::size_t at = static_cast<std::size_t>(j * kHazeBlock_px + 4) * parts.stride + i * kHazeBlock_px + 4;
      const Vector3f view = motion.pose.linear() *
                            parts.ray_of(i * kHazeBlock_px + kHazeBlock_px / 2, j * kHazeBlock_px + kHazeBlock_px / 2);
      float sums[2] = {0.0f, 0.0f};
      for (const ForeignLamp& lamp : parts.foreign_lamps) {
        const float value = haze_along(lamp, dust, eye, view, parts.range[at]);
        if (value < least) continue;
        // One look from the place on the ray that is closest to the lamp.
        const float s = std::clamp(view.dot(lamp.place - eye), 0.0f, 0.98f * parts.range[at]);
        if (parts.render.shadows && parts.scene->occluded(eye + view * s, lamp.place)) continue;
        sums[lamp.daylight ? 1 : 0] += value;
      }
      haze[static_cast<std::size_t>(j) * across + i] = sums[0];
      day[static_cast<std::size_t>(j) * across + i] = sums[1];
    }
  });
  const RenderConfig& r = parts.render;
  parts.each(parts.height, [&](int v) {
    const float y = std::clamp((static_cast<float>(v) - 3.5f) / kHazeBlock_px, 0.0f, static_cast<float>(down - 1));
    const int j = std::min(static_cast<int>(y), down - 2);
    const float fy = y - static_cast<float>(j);
    for (int u = 0; u < parts.width; ++u) {
      const float x = std::clamp((static_cast<float>(u) - 3.5f) / kHazeBlock_px, 0.0f, static_cast<float>(across - 1));
      const int i = std::min(static_cast<int>(x), across - 2);
      const float fx = x - static_cast<float>(i);
      const auto between = [&](const std::vector<float>& g) {
        const float* p = &g[static_cast<std::size_t>(j) * across + i];
        return (1 - fy) * ((1 - fx) * p[0] + fx * p[1]) + fy * ((1 - fx) * p[across] + fx * p[across + 1]);
      };
      const float lamp = between(haze), sky = between(day);
      const std::size_t at = static_cast<std::size_t>(v) * parts.stride + u;
      parts.planes[0][at] += lamp * r.foreign_red + sky;
      parts.planes[1][at] += lamp + sky;
      parts.planes[2][at] += lamp * r.foreign_blue + sky;
    }
  });
}

/// A foreign lamp as the camera sees it.
struct SeenLamp {
  double u_px, v_px;
  float radius_px, luminance, lux, range_m, visible_fraction;
};

/// Draws the emitter where nothing is nearer, at least 0.8 px in radius with its light conserved.
/// @return the share of its disc that is in sight.
float draw_emitter(Renderer::Parts& parts, const SeenLamp& s, float emitter_radius_m) {
  const float radius = std::max(s.radius_px, 0.8f);
  const float luminance = s.luminance * (s.radius_px * s.radius_px) / (radius * radius);
  float drawn = 0.0f, whole = 0.0f;
  const int reach = static_cast<int>(radius + 2.0f);
  const int cu = static_cast<int>(std::lround(s.u_px)), cv = static_cast<int>(std::lround(s.v_px));
  for (int v = cv - reach; v <= cv + reach; ++v)
    for (int u = cu - reach; u <= cu + reach; ++u) {
      const float du = static_cast<float>(u - s.u_px), dv = static_cast<float>(v - s.v_px);
      const float cover = std::clamp(radius + 0.5f - std::sqrt(du * du + dv * dv), 0.0f, 1.0f);
      if (cover <= 0.0f) continue;
      whole += cover;
      if (u < 0 || v < 0 || u >= parts.width || v >= parts.height) continue;
      const std::size_t at = static_cast<std::size_t>(v) * parts.stride + u;
      if (parts.range[at] < s.range_m - 1.5f * emitter_radius_m) continue;
      drawn += cover;
      parts.planes[0][at] += cover * luminance * parts.render.foreign_red;
      parts.planes[1][at] += cover * luminance;
      parts.planes[2][at] += cover * luminance * parts.render.foreign_blue;
    }
  return whole > 0.0f ? drawn / whole : 0.0f;
}

std::vector<SeenLamp> draw_emitters(Renderer::Parts& parts, const CameraMotion& motion) {
  std::vector<SeenLamp> seen;
  const Eigen::Isometry3f to_camera = motion.pose.inverse();
  for (const ForeignLamp& lamp : parts.foreign_lamps) {
    if (lamp.daylight) continue;
    const Vector3f p = to_camera * lamp.place;
    if (p.z() < 0.05f || p.head<2>().norm() > 3.0f * p.z()) continue;
    const Pixel pixel = parts.camera->pixel_of(NormalisedPoint{p.x() / p.z(), p.y() / p.z()});
    const float range = p.norm();
    const float intensity = lamp.intensity_cd *
                            lamp.lobe.at(-(lamp.place - motion.pose.translation()).dot(lamp.axis) / range) *
                            std::exp(-parts.rig.dust.extinction_1_m * range);
    const float area = std::numbers::pi_v<float> * lamp.radius_m * lamp.radius_m;
    SeenLamp s{pixel.u_px,
               pixel.v_px,
               lamp.radius_m / (range * parts.pixel_angle),
               intensity / area,
               intensity / (range * range),
               range,
               0.0f};
    if (s.u_px < -200 || s.v_px < -200 || s.u_px > parts.width + 200 || s.v_px > parts.height + 200) continue;
    s.visible_fraction = draw_emitter(parts, s, lamp.radius_m);
    if (s.visible_fraction > 0.0f) seen.push_back(s);
  }
  return seen;
}

/// Veiling light about a lamp: L = glare * E / angle^2 (after the CIE's disability glare, where it is 10 for an eye).
void add_glare(Renderer::Parts& parts, const std::vector<SeenLamp>& lamps, float least) {
  const float glare = parts.rig.lens.glare;
  if (glare <= 0.0f) return;
  const float degrees_a_pixel = parts.pixel_angle * 180.0f / std::numbers::pi_v<float>;
  for (const SeenLamp& s : lamps) {
    const float strength = glare * s.lux * s.visible_fraction / (degrees_a_pixel * degrees_a_pixel);
    const float reach = std::sqrt(strength / std::max(least, 1e-9f));
    const float core = std::max(s.radius_px * s.radius_px, 2.0f);
    const auto bound = [](double x, int high) {
      return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(high)));
    };
    const int v_from = bound(s.v_px - reach, parts.height), v_to = bound(s.v_px + reach + 1, parts.height);
    const int u_from = bound(s.u_px - reach, parts.width), u_to = bound(s.u_px + reach + 1, parts.width);
    parts.each(v_to - v_from, [&](int k) {
      const int v = v_from + k;
      const float dv = static_cast<float>(v - s.v_px);
      const std::size_t at = static_cast<std::size_t>(v) * parts.stride;
      for (int u = u_from; u < u_to; ++u) {
        const float du = static_cast<float>(u - s.u_px);
        // Smoothly to nothing at the edge of the reach.
        const float veil = std::max(0.0f, strength / (du * du + dv * dv + core) - least);
        parts.planes[0][at + u] += veil * parts.render.foreign_red;
        parts.planes[1][at + u] += veil;
        parts.planes[2][at + u] += veil * parts.render.foreign_blue;
      }
    });
  }
}

/// See blur.inl.
void blur_motion(Renderer::Parts& parts, const CameraMotion& motion, float time_s) {
  const ShadeKernels& kernels = shade_kernels();
  const CameraModel& m = parts.camera->model();
  parts.each(parts.height, [&](int v) {
    const std::size_t at = static_cast<std::size_t>(v) * parts.stride;
    BlurRow row{};
    for (int c = 0; c < 3; ++c) {
      row.run_directions[c] =
          &parts.run_directions[(static_cast<std::size_t>(v) * 3 + c) * (parts.stride / kBlurRun_px)];
      row.planes[c] = parts.planes[c].data();
      row.blurred[c] = &parts.blurred[c][at];
      row.turn_rate_rad_s[c] = motion.turn_rate_rad_s[c];
      row.velocity_m_s[c] = motion.velocity_m_s[c];
    }
    row.range = &parts.range[at];
    row.focal_x_px = static_cast<float>(m.focal_length_x_px);
    row.focal_y_px = static_cast<float>(m.focal_length_y_px);
    row.time_s = time_s;
    row.row = v;
    row.width = parts.width;
    row.height = parts.height;
    row.stride = parts.stride;
    kernels.blur_row(row);
  });
  for (int c = 0; c < 3; ++c) std::swap(parts.planes[c], parts.blurred[c]);
}

/// Half a pixel within the exposure, anywhere in the frame, is worth the work.
bool moves(const Renderer::Parts& parts, const CameraMotion& motion, float time_s) {
  const float near_m = 0.5f;
  return (motion.turn_rate_rad_s.norm() + motion.velocity_m_s.norm() / near_m) * time_s > 0.5f * parts.pixel_angle;
}

}  // namespace

void lens_pass(Renderer::Parts& parts, const CameraMotion& motion, const Shot& shot) {
  add_foreign_haze(parts, motion);
  const std::vector<SeenLamp> lamps = draw_emitters(parts, motion);
  if (parts.render.motion_blur && moves(parts, motion, shot.exposure.time_s))
    blur_motion(parts, motion, shot.exposure.time_s);
  add_glare(parts, lamps, parts.render.cull_fraction * motion.white_luminance);
  grains_pass(parts, motion, shot);
}

}  // namespace adit::sim
