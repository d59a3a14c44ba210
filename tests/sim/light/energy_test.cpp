#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bare_rig.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
using test::bare_render;
using test::bare_rig;
using test::box_world;
using test::direction_of;
using test::shot_at;

constexpr float kAlbedo = 0.3f;
constexpr float kPi = std::numbers::pi_v<float>;

/// Every pixel sees the wall x = distance; its luminance is albedo / pi * I * cos / r^2.
TEST(Energy, APlaneObeysInverseSquareAndLambert) {
  const World world = box_world({-50, -100, -100}, {0, 100, 100}, kAlbedo);
  for (const float distance : {1.0f, 3.0f, 12.0f}) {
    Renderer renderer(world, bare_rig(460.0f), bare_render());
    const Radiance seen = renderer.radiance(shot_at({-distance, 0, 0}));
    for (int v = 0; v < seen.height; v += 7)
      for (int u = 0; u < seen.width; u += 7) {
        const Vector3f d = direction_of(renderer.camera(), u, v);
        const float range = distance / d.x(), cosine = d.x();
        const float expected = kAlbedo / kPi * 460.0f * cosine / (range * range);
        const float got = seen.green[static_cast<std::size_t>(v * seen.width + u)];
        EXPECT_NEAR(got, expected, 1e-3f * expected) << "at " << u << ", " << v << ", " << distance << " m";
      }
  }
}

TEST(Energy, ALobeFallsOffAsItsExponentSays) {
  const World world = box_world({-50, -100, -100}, {0, 100, 100}, kAlbedo);
  RigConfig rig = bare_rig(100.0f);
  rig.lamps.lamps[0].lobe_exponent = 6.0f;
  Renderer renderer(world, rig, bare_render());
  const Radiance seen = renderer.radiance(shot_at({-2, 0, 0}));
  for (int u = 0; u < seen.width; u += 3) {
    const float cosine = direction_of(renderer.camera(), u, 60).x();
    const float expected = kAlbedo / kPi * 100.0f * std::pow(cosine, 6.0f) * cosine * cosine * cosine / 4.0f;
    EXPECT_NEAR(seen.green[static_cast<std::size_t>(60 * seen.width + u)], expected, 2e-3f * expected);
  }
}

/// All light of a lamp lands on the walls round it: the sum of flux over the sphere is what the field says.
TEST(Energy, TheFluxOfALobeIsItsIntegral) {
  for (const float n : {0.0f, 1.0f, 4.0f, 40.0f}) {
    const LampLobe lobe(n, 90.0f, 1.0f, 0.0f);
    const float expected = n == 0.0f ? 4.0f * kPi : 2.0f * kPi / (n + 1.0f);
    EXPECT_NEAR(lobe.solid_angle_sr(), expected, 1e-3f * expected) << "exponent " << n;
  }
  Lamp lamp;
  lamp.lobe_exponent = 3.0f;
  lamp.flux_lm = 1000.0f;
  EXPECT_NEAR(intensity_on_axis_cd(lamp), 1000.0f * 4.0f / (2.0f * kPi), 0.5f);
}

TEST(Energy, TwoLampsAddAndALampBehindAPillarDoesNot) {
  World world = box_world({-50, -100, -100}, {0, 100, 100}, kAlbedo);
  RigConfig two = bare_rig(100.0f);
  two.lamps.lamps.push_back(two.lamps.lamps[0]);
  Renderer one_lamp(world, bare_rig(100.0f), bare_render()), two_lamps(world, two, bare_render());
  const Radiance a = one_lamp.radiance(shot_at({-3, 0, 0})), b = two_lamps.radiance(shot_at({-3, 0, 0}));
  for (std::size_t i = 0; i < a.green.size(); i += 31) EXPECT_NEAR(b.green[i], 2 * a.green[i], 1e-4f * b.green[i]);

  // A plate between a lamp 2 m to the left and the middle of the wall; the lens looks past it.
  const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
  for (const Vector3f& p :
       {Vector3f(-1.5f, 0.8f, -9), Vector3f(-1.5f, 1.2f, -9), Vector3f(-1.5f, 1.2f, 9), Vector3f(-1.5f, 0.8f, 9)})
    world.mesh.vertices.push_back(p);
  world.mesh.triangles.emplace_back(first, first + 1, first + 2);
  world.mesh.triangles.emplace_back(first, first + 2, first + 3);
  world.mesh.materials.insert(world.mesh.materials.end(), 2, std::uint8_t{0});
  RigConfig side = bare_rig(100.0f);
  side.lamps.lamps[0].left_m = 1.0f;
  side.lens.hfov_deg = 40.0f;
  // The lamp at y = 1 lights the wall but for the plate's shadow, about y in [0.6, 1.4].
  Renderer renderer(world, side, bare_render());
  const Radiance seen = renderer.radiance(shot_at({-3, 0, 0}));
  const auto at = [&](float y) {
    const auto u =
        static_cast<std::size_t>(std::lround(renderer.camera().pixel_of(NormalisedPoint{-y / 3.0, 0.0}).u_px));
    return seen.green[60 * static_cast<std::size_t>(seen.width) + u];
  };
  EXPECT_GT(at(0.0f), 0.5f);
  EXPECT_GT(at(0.4f), 0.5f);
  EXPECT_EQ(at(0.7f), 0.0f) << "in the shadow of the plate";
}

TEST(Energy, IndirectLightIsThereAndIsSmall) {
  const World world = box_world({-5, -2, -1}, {15, 2, 3}, kAlbedo);
  RenderConfig with = bare_render();
  with.virtual_lights = 64;
  Renderer direct(world, bare_rig(), bare_render()), both(world, bare_rig(), with);
  const Radiance a = direct.radiance(shot_at({0, 0, 1})), b = both.radiance(shot_at({0, 0, 1}));
  double sum_a = 0.0, sum_b = 0.0;
  for (std::size_t i = 0; i < a.green.size(); ++i) {
    EXPECT_GE(b.green[i], a.green[i]);
    sum_a += static_cast<double>(a.green[i]);
    sum_b += static_cast<double>(b.green[i]);
  }
  // Inside a closed box of albedo 0.3 the first bounce adds at most 0.3 of the mean; half of it lands out of sight.
  EXPECT_GT(sum_b, 1.03 * sum_a);
  EXPECT_LT(sum_b, 1.6 * sum_a);
}

}  // namespace
}  // namespace adit::sim
