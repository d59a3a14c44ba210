// Light that rock sends on once, as points of light (Keller, Instant Radiosity, 1997). The directions in which a lamp
// is probed are fixed to the lamp, so that the points move smoothly with it and the same pose gives the same points.
#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace adit::sim {
namespace {

/// Cosine of the angle inside which the share x of the lobe's flux goes.
float cosine_of_share(const LampLobe& lobe, float x) {
  constexpr int kSteps = 256;
  const float total = lobe.solid_angle_sr() / (2.0f * std::numbers::pi_v<float>);
  float sum = 0.0f;
  for (int i = 0; i < kSteps; ++i) {
    // Even in s = sin(t/2): the solid angle of a ring is 4 s ds (over 2 pi).
    const float s = (static_cast<float>(i) + 0.5f) / kSteps;
    const float cosine = 1.0f - 2.0f * s * s;
    sum += lobe.at(cosine) * 4.0f * s / kSteps;
    if (sum >= x * total) return cosine;
  }
  return -1.0f;
}

}  // namespace

void add_bounces(std::vector<VirtualLight>& lights, const World& world, const RayScene& scene,
                 const Eigen::Isometry3f& pose, const LampLobe& lobe, float intensity_cd, int count,
                 float extinction_1_m, int colour) {
  constexpr float kGoldenAngle = 2.39996323f;
  const float flux = intensity_cd * lobe.solid_angle_sr() / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float cosine = cosine_of_share(lobe, (static_cast<float>(i) + 0.5f) / static_cast<float>(count));
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    const float turn = kGoldenAngle * static_cast<float>(i);
    const Eigen::Vector3f direction =
        pose.linear() * Eigen::Vector3f(sine * std::cos(turn), sine * std::sin(turn), cosine);
    const auto hit = scene.closest_hit(pose.translation(), direction, 200.0f);
    if (!hit) continue;
    const Material& material = world.materials[world.mesh.materials[hit->triangle]];
    const Eigen::Vector3f place = hit->place + 0.02f * hit->normal;
    VirtualLight light;
    for (int k = 0; k < 3; ++k) {
      light.place[k] = place[k];
      light.normal[k] = hit->normal[k];
    }
    light.power = flux * material.albedo / std::numbers::pi_v<float> * std::exp(-extinction_1_m * hit->range_m);
    light.colour = colour;
    lights.push_back(light);
  }
}

}  // namespace adit::sim
