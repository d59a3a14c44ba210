// Dirt on the front glass: it takes light away from the same places of every frame.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../sensor/hash.hpp"
#include "parts.hpp"

namespace adit::sim {
namespace {

struct Spot {
  float azimuth_deg, elevation_deg;
};

/// The first where it was asked for, the others anywhere in the frame.
std::vector<Spot> spots_of(const DirtConfig& dirt, const LensConfig& lens) {
  std::vector<Spot> spots;
  const float across_deg = 0.5f * lens.hfov_deg;
  const float down_deg = across_deg * static_cast<float>(lens.height) / static_cast<float>(lens.width);
  const auto either_side = [](std::uint64_t bits) {
    return static_cast<float>(bits >> 40) / static_cast<float>(1u << 23) - 1.0f;
  };
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(dirt.spots); ++i) {
    if (i == 0)
      spots.push_back({dirt.azimuth_deg, dirt.elevation_deg});
    else
      spots.push_back({across_deg * either_side(hashed(2 * i)), down_deg * either_side(hashed(2 * i + 1))});
  }
  return spots;
}

/// A dark disc with a soft edge: 1 within, 0 outside, half at the radius.
float cover_of(float off_deg, const DirtConfig& dirt) {
  const float way = std::clamp((off_deg - dirt.radius_deg) / dirt.edge_deg + 0.5f, 0.0f, 1.0f);
  return 0.5f + 0.5f * std::cos(std::numbers::pi_v<float> * way);
}

}  // namespace

std::vector<float> dirt_passed_of(const Renderer::Parts& parts) {
  std::vector<float> passed;
  const DirtConfig& dirt = parts.rig.dirt;
  if (dirt.spots == 0) return passed;
  const std::vector<Spot> spots = spots_of(dirt, parts.rig.lens);
  passed.reserve(static_cast<std::size_t>(parts.width) * parts.height);
  for (int v = 0; v < parts.height; ++v)
    for (int u = 0; u < parts.width; ++u) {
      const Bearing at = parts.camera->bearing_of({static_cast<double>(u), static_cast<double>(v)});
      float share = 1.0f;
      for (const Spot& spot : spots) {
        constexpr double kDegrees = 180.0 / std::numbers::pi;
        const float across = static_cast<float>(at.azimuth_rad * kDegrees) - spot.azimuth_deg;
        const float up = static_cast<float>(at.elevation_rad * kDegrees) - spot.elevation_deg;
        share *= 1.0f - dirt.opacity * cover_of(std::hypot(across, up), dirt);
      }
      passed.push_back(share);
    }
  return passed;
}

void dirt_pass(Renderer::Parts& parts) {
  if (parts.dirt_passed.empty()) return;
  parts.each(parts.height, [&](int v) {
    const float* const passed = &parts.dirt_passed[static_cast<std::size_t>(v) * parts.width];
    for (std::vector<float>& plane : parts.planes) {
      float* const row = &plane[static_cast<std::size_t>(v) * parts.stride];
      for (int u = 0; u < parts.width; ++u) row[u] *= passed[u];
    }
  });
}

}  // namespace adit::sim
