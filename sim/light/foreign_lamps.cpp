// Lamps that stand in the world, and daylight through its mouths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;

Eigen::Isometry3f frame_along(const Vector3f& place, const Vector3f& axis) {
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity();
  pose.translate(place);
  pose.rotate(Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitZ(), axis));
  return pose;
}

/// The direction into the rock at a mouth, and the passage's size there.
struct Mouth {
  Vector3f centre, inward;
  float width_m, height_m;
};

std::vector<Mouth> mouths_of(const World& world) {
  std::vector<Mouth> mouths;
  for (const Passage& p : world.passages) {
    if (p.axis.size() < 2) continue;
    const auto is_mouth = [&](int node) {
      return node >= 0 && node < static_cast<int>(world.nodes.size()) &&
             world.nodes[static_cast<std::size_t>(node)].kind == NodeKind::kMouth;
    };
    const auto add = [&](const AxisPoint& end, const AxisPoint& next) {
      Vector3f inward = next.place - end.place;
      inward.z() = 0.0f;
      if (inward.norm() < 1e-3f) return;
      mouths.push_back(
          {end.place + Vector3f(0, 0, 0.5f * end.height_m), inward.normalized(), end.width_m, end.height_m});
    };
    if (is_mouth(p.from)) add(p.axis.front(), p.axis[1]);
    if (is_mouth(p.to)) add(p.axis.back(), p.axis[p.axis.size() - 2]);
  }
  return mouths;
}

}  // namespace

std::vector<ForeignLamp> foreign_lamps_of(const World& world, const RayScene&) {
  std::vector<ForeignLamp> lamps;
  for (const WorldLamp& lamp : world.lamps) {
    LampLobe lobe(lamp.lobe_exponent, 90.0f, 1.0f, 0.0f);
    const float intensity = lamp.flux_lm / lobe.solid_angle_sr();
    lamps.push_back({lamp.place, lamp.axis.normalized(), lobe, intensity, lamp.emitter_radius_m, false});
  }
  if (world.sky_lux <= 0.0f) return lamps;
  // A mouth is a window of the sky's luminance: each of its pieces shines with Lambert's cosine into the rock.
  constexpr int kPieces = 3;
  const float luminance = world.sky_lux / std::numbers::pi_v<float>;
  const LampLobe cosine(1.0f, 90.0f, 1.0f, 0.0f);
  for (const Mouth& mouth : mouths_of(world)) {
    const Vector3f left = Vector3f::UnitZ().cross(mouth.inward);
    const float area = 0.8f * mouth.width_m * mouth.height_m / (kPieces * kPieces);
    for (int j = 0; j < kPieces; ++j)
      for (int i = 0; i < kPieces; ++i) {
        const float a = (static_cast<float>(i) + 0.5f) / kPieces - 0.5f;
        const float b = (static_cast<float>(j) + 0.5f) / kPieces - 0.5f;
        const Vector3f place =
            mouth.centre + 0.8f * (a * mouth.width_m * left + b * mouth.height_m * Vector3f::UnitZ());
        lamps.push_back({place, mouth.inward, cosine, luminance * area, 0.5f * std::sqrt(area), true});
      }
  }
  return lamps;
}

std::vector<VirtualLight> bounces_of_foreign(const World& world, const RayScene& scene,
                                             const std::vector<ForeignLamp>& lamps, float extinction_1_m) {
  std::vector<VirtualLight> lights;
  for (const ForeignLamp& lamp : lamps)
    add_bounces(lights, world, scene, frame_along(lamp.place, lamp.axis), lamp.lobe, lamp.intensity_cd,
                lamp.daylight ? 3 : 8, extinction_1_m, lamp.daylight ? 2 : 1);
  return lights;
}

}  // namespace adit::sim
