#include "drawn_passage.hpp"

#include <algorithm>
#include <cmath>

namespace adit::test {
namespace {

std::uint8_t level_of(double level) { return static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L)); }

/// Bumps of several sizes, -1 to 1.
double bumps(double u, double v) {
  return 0.5 * std::sin(u / 23.0 + 1.3 * std::sin(v / 31.0)) + 0.3 * std::sin(v / 17.0 + std::sin(u / 41.0)) +
         0.2 * std::sin((u + v) / 7.0);
}

/// Share of the lamp's light that comes back: 0 deep in an opening, 1 on the rock about it, gradual between.
double rock_share(const DrawnScene& scene, double u, double v) {
  double share = 1.0;
  for (const DrawnOpening& opening : scene.openings) {
    const double du = (u - opening.u_px) / opening.half_width_px, dv = (v - opening.v_px) / opening.half_height_px;
    const double radius = std::sqrt(du * du + dv * dv);
    share = std::min(share, std::clamp((radius - 0.6) / 0.6, 0.0, 1.0));
  }
  return share;
}

}  // namespace

Frame drawn(const DrawnScene& scene) {
  Frame frame(scene.width, scene.height, PixelFormat::kGrey8);
  std::mt19937 random(scene.seed);
  for (int v = 0; v < scene.height; ++v) {
    for (int u = 0; u < scene.width; ++u) {
      const double from_middle = std::hypot(u - 0.5 * scene.width, v - 0.5 * scene.height);
      const double beam = std::exp2(-from_middle * from_middle / (scene.beam_px * scene.beam_px));
      const double rock = scene.brightness * (1.0 + scene.texture * bumps(u, v)) * rock_share(scene, u, v);
      const double noise = between(random, -scene.noise, scene.noise);
      *frame.pixel(u, v) = level_of(beam * (rock + scene.veil) + 3.0 + noise);
    }
  }
  return frame;
}

void add_lamp(Frame& grey, double u_px, double v_px, double radius_px) {
  for (int v = 0; v < grey.height; ++v) {
    for (int u = 0; u < grey.width; ++u) {
      const double distance = std::max(1.0, std::hypot(u - u_px, v - v_px) / radius_px);
      std::uint8_t& level = *grey.pixel(u, v);
      level = level_of(level + 255.0 / (distance * distance));
    }
  }
}

void add_cable(Frame& grey, double v_px, double thickness_px) {
  for (int v = 0; v < grey.height; ++v) {
    if (std::abs(v - v_px) > 0.5 * thickness_px) continue;
    for (int u = 0; u < grey.width; ++u) *grey.pixel(u, v) = 8;
  }
}

}  // namespace adit::test
