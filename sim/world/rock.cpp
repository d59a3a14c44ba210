#include "rock.hpp"

#include <algorithm>
#include <cmath>

namespace adit::sim {
namespace {

/// Relief of the floor gives way to that of the wall between these heights.
constexpr float kFloorTop_m = 0.1f;
constexpr float kWallFoot_m = 0.7f;

float smooth_step(float low, float high, float x) noexcept {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

Rock::Rock(const PassageField& field, const CourseConfig& config)
    : field_(&field),
      undulation_m_(static_cast<float>(config.undulation_m)),
      undulation_size_m_(static_cast<float>(config.undulation_size_m)),
      grain_depth_m_(static_cast<float>(config.grain_depth_m)),
      grain_size_m_(static_cast<float>(config.grain_size_m)),
      floor_roughness_m_(static_cast<float>(config.floor_roughness_m)),
      seed_(mixed(static_cast<std::uint32_t>(config.seed))),
      facets_(static_cast<float>(config.facet_size_m), static_cast<float>(config.facet_depth_m), seed_ ^ 0x11u),
      chips_(static_cast<float>(config.chip_size_m), static_cast<float>(config.chip_depth_m), seed_ ^ 0x22u) {
  const double wall = config.undulation_m + 1.5 * (config.facet_depth_m + config.chip_depth_m) + config.grain_depth_m;
  reach_m_ = static_cast<float>(std::max(wall, 3.0 * config.floor_roughness_m));
}

void Rock::prepare(const Eigen::Vector3f& low, const Eigen::Vector3f& high, PassageField::Candidates candidates) {
  candidates_ = std::move(candidates);
  facets_.prepare(low, high);
  chips_.prepare(low, high);
}

float Rock::wall_relief(const Eigen::Vector3f& p) const noexcept {
  const float undulation = gradient_noise(p / undulation_size_m_, seed_ ^ 0x33u);
  // Ridged: creases where the noise goes through zero, as along cracks.
  const float ridge = 1.0f - 2.0f * std::abs(gradient_noise(p / grain_size_m_, seed_ ^ 0x44u));
  return undulation_m_ * undulation + facets_.at(p) + chips_.at(p) + grain_depth_m_ * ridge;
}

float Rock::floor_relief(const Eigen::Vector3f& p) const noexcept {
  const Eigen::Vector3f low(p.x() / 2.3f, p.y() / 2.3f, p.z() / 2.3f);
  const float ruts = gradient_noise(low, seed_ ^ 0x55u);
  const float lumps = gradient_noise(p / 0.45f, seed_ ^ 0x66u);
  return floor_roughness_m_ * (1.4f * ruts + 0.9f * lumps);
}

float Rock::at(const Eigen::Vector3f& p) const noexcept {
  const OpenDistance open = field_->at(p, candidates_);
  if (std::abs(open.distance) > reach_m_) return open.distance;
  const float wall = smooth_step(kFloorTop_m, kWallFoot_m, open.above_floor);
  float relief = 0.0f;
  if (wall > 0.0f) relief += wall * wall_relief(p);
  if (wall < 1.0f) relief += (1.0f - wall) * floor_relief(p);
  return open.distance - relief;
}

RockMaterial material_at(const Eigen::Vector3f& p, float above_floor, float upward, float wet_fraction,
                         std::uint32_t seed) noexcept {
  const bool on_floor = above_floor < 0.45f && upward > 0.6f;
  // Streaks run down the wall: long in z. Puddles lie flat. Gradient noise is nearly normal with sigma 0.27.
  const Eigen::Vector3f streak = on_floor ? Eigen::Vector3f(p.x() / 1.7f, p.y() / 1.7f, 0.0f)
                                          : Eigen::Vector3f(p.x() / 0.8f, p.y() / 0.8f, p.z() / 6.0f);
  const Eigen::Vector3f region(p.x() / 7.0f, p.y() / 7.0f, p.z() / 7.0f);
  const float wetness = gradient_noise(streak, seed ^ 0x77u) + 0.8f * gradient_noise(region, seed ^ 0x88u);
  // The share of a normal distribution (sigma 0.34) above x is wet_fraction; a logistic is near enough to it.
  const float share = std::clamp(wet_fraction, 1e-4f, 1.0f - 1e-4f);
  const bool wet = wetness > 0.34f * std::log((1.0f - share) / share) / 1.7f;
  if (on_floor) return wet ? RockMaterial::kWetGravel : RockMaterial::kGravel;
  return wet ? RockMaterial::kWetRock : RockMaterial::kRock;
}

std::vector<Material> materials_of(const CourseConfig& config) {
  const auto albedo = static_cast<float>(config.rock_albedo);
  const auto sigma = static_cast<float>(config.rock_albedo_log_sigma);
  // Wetting darkens rock to about half, since light stays in the film of water; the film adds the gloss.
  // Iron makes most rock warm: ochre rather than grey.
  const Eigen::Vector3f rock(1.0f, 0.90f, 0.70f);
  const Eigen::Vector3f grey(1.0f, 1.0f, 1.0f);
  const Eigen::Vector3f wood(1.0f, 0.78f, 0.55f);
  const Eigen::Vector3f rust(1.0f, 0.68f, 0.5f);
  const Eigen::Vector3f yellow(1.2f, 1.0f, 0.35f);
  // name, albedo, its sigma, patches, specular, shininess, emission, slope and size of the finest facets, tint
  return {
      {"rock", albedo, sigma, 0.6f, 0.0f, 30.0f, 0.0f, 0.35f, 0.3f, rock},
      {"wet_rock", 0.5f * albedo, sigma, 0.5f, 0.25f, 90.0f, 0.0f, 0.25f, 0.3f, rock},
      {"gravel", 0.8f * albedo, sigma, 0.3f, 0.0f, 30.0f, 0.0f, 0.3f, 0.09f, rock},
      {"wet_gravel", 0.4f * albedo, sigma, 0.25f, 0.3f, 120.0f, 0.0f, 0.12f, 0.1f, rock},
      {"stone", 0.8f * albedo, sigma, 0.4f, 0.0f, 30.0f, 0.0f, 0.2f, 0.1f, rock},
      {"pipe", 0.35f, 0.15f, 0.8f, 0.2f, 40.0f, 0.0f, 0.0f, 0.3f, grey},
      {"cable", 0.04f, 0.1f, 0.5f, 0.08f, 40.0f, 0.0f, 0.0f, 0.3f, grey},
      {"timber", 0.25f, 0.3f, 0.2f, 0.0f, 30.0f, 0.0f, 0.1f, 0.1f, wood},
      {"steel", 0.18f, 0.35f, 0.3f, 0.1f, 30.0f, 0.0f, 0.02f, 0.3f, rust},
      {"duct", 0.45f, 0.1f, 1.0f, 0.1f, 25.0f, 0.0f, 0.05f, 0.4f, yellow},
      {"lamp_glass", 0.5f, 0.0f, 0.5f, 0.0f, 30.0f, 20000.0f, 0.0f, 0.3f, grey},
  };
}

}  // namespace adit::sim
