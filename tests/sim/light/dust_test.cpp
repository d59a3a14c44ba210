#include "adit/sim/dust.hpp"

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

TEST(Dust, AttenuationIsBeerAndLamberts) {
  const World world = box_world({-50, -100, -100}, {0, 100, 100});
  Renderer clear(world, bare_rig(), bare_render());
  const Radiance a = clear.radiance(shot_at({-4, 0, 0}));
  for (const float sigma : {0.02f, 0.1f, 0.5f}) {
    RigConfig rig = bare_rig();
    rig.dust.extinction_1_m = sigma;
    rig.dust.scattering_albedo = 0.0f;  // light is taken, none comes back
    Renderer dusty(world, rig, bare_render());
    const Radiance b = dusty.radiance(shot_at({-4, 0, 0}));
    for (int v = 0; v < a.height; v += 11)
      for (int u = 0; u < a.width; u += 11) {
        const auto i = static_cast<std::size_t>(v * a.width + u);
        const float range = 4.0f / direction_of(clear.camera(), u, v).x();
        EXPECT_NEAR(b.green[i] / a.green[i], std::exp(-2.0f * sigma * range), 1e-4f)
            << "both ways, " << sigma << " 1/m";
      }
  }
}

TEST(Dust, ThePhaseFunctionIsNormalised) {
  for (const float g : {-0.5f, 0.0f, 0.7f, 0.85f}) {
    double sum = 0.0, mean = 0.0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      const double c = -1.0 + 2.0 * (i + 0.5) / kSteps;
      const double p = static_cast<double>(henyey_greenstein(static_cast<float>(c), g));
      sum += p * 2.0 * std::numbers::pi * 2.0 / kSteps;
      mean += c * p * 2.0 * std::numbers::pi * 2.0 / kSteps;
    }
    EXPECT_NEAR(sum, 1.0, 1e-3);
    EXPECT_NEAR(mean, static_cast<double>(g), 2e-3);
  }
}

/// Midpoint rule with many steps against the table that the renderer looks up.
TEST(Dust, BackscatterIsTheIntegralAlongTheRay) {
  // A black wall: what is seen is haze alone.
  const World world = box_world({-50, -100, -100}, {0, 100, 100}, 0.0f);
  RigConfig rig = bare_rig();
  rig.dust = DustConfig{};
  rig.dust.extinction_1_m = 0.15f;
  rig.lamps.lamps[0].left_m = 0.2f;
  rig.lamps.lamps[0].lobe_exponent = 3.0f;
  for (const float distance : {1.5f, 6.0f, 40.0f}) {
    Renderer renderer(world, rig, bare_render());
    const Radiance seen = renderer.radiance(shot_at({-distance, 0, 0}));
    for (int v = 20; v < seen.height; v += 40)
      for (int u = 8; u < seen.width; u += 36) {
        const Vector3f d = direction_of(renderer.camera(), u, v);
        const float range = distance / d.x();
        const Vector3f lamp(0, 0.2f, 0);
        constexpr int kSteps = 20000;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
          const float s = range * (static_cast<float>(i) + 0.5f) / kSteps;
          const Vector3f way = d * s - lamp;
          const float l = way.norm(), cosine = way.x() / l;
          if (cosine <= 0.0f) continue;
          sum +=
              static_cast<double>(100.0f * cosine * cosine * cosine / (l * l) *
                                  henyey_greenstein(-way.dot(d) / l, rig.dust.asymmetry) * std::exp(-0.15f * (l + s)));
        }
        const double expected =
            sum * static_cast<double>(range) / kSteps * 0.15 * static_cast<double>(rig.dust.scattering_albedo);
        const double got = static_cast<double>(seen.green[static_cast<std::size_t>(v * seen.width + u)]);
        EXPECT_NEAR(got, expected, 0.03 * expected) << u << ", " << v << " at " << distance << " m";
      }
  }
}

TEST(Dust, GrainsDriftWithTimeAndAreTheSameForTheSameTime) {
  const World world = box_world({-5, -2, -1}, {15, 2, 3}, 0.02f);
  RigConfig rig = bare_rig(460.0f);
  rig.dust.grains_per_m3 = 800.0f;
  Renderer renderer(world, rig, bare_render());
  Shot shot = shot_at({0, 0, 1});
  shot.exposure = {0.02f, 8.0f};
  const Radiance a = renderer.radiance(shot), b = renderer.radiance(shot);
  shot.time_s = 0.2;
  const Radiance c = renderer.radiance(shot);
  EXPECT_EQ(a.green, b.green);
  EXPECT_NE(a.green, c.green);
}

}  // namespace
}  // namespace adit::sim
