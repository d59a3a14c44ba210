// What pixels see, drawn by whole tiles, beside the plain way: a ray of Embree for each.
#include <gtest/gtest.h>

#include <cmath>

#include "adit/sim/random.hpp"
#include "adit/sim/render.hpp"
#include "bare_rig.hpp"
#include "box.hpp"
#include "tile.hpp"

namespace adit::sim {
namespace {

/// A closed box full of splinters, small and large, near and far.
World splinter_world() {
  World world = test::box_world({-4, -5, -1}, {40, 5, 4});
  Random random(11, 0);
  const auto between = [&random](double low, double high) {
    return static_cast<float>(low + (high - low) * random.uniform());
  };
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector3f middle(between(0.5, 39), between(-4.5, 4.5), between(-0.5, 3.5));
    const float size = 0.02f * middle.x() * between(0.05, 1.0);
    const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
    for (int k = 0; k < 3; ++k)
      world.mesh.vertices.push_back(middle + size * Eigen::Vector3f(between(-1, 1), between(-1, 1), between(-1, 1)));
    world.mesh.triangles.emplace_back(first, first + 1, first + 2);
    world.mesh.materials.push_back(0);
  }
  return world;
}

/// Share of the pixels whose range is not that of their own ray, to a ten-thousandth.
double share_that_differs(const Renderer& renderer, const Frame& frame, const Shot& shot) {
  const Eigen::Isometry3f pose = renderer.camera_pose(shot.pose);
  int differ = 0;
  for (int v = 0; v < frame.height; ++v)
    for (int u = 0; u < frame.width; ++u) {
      const NormalisedPoint n = renderer.camera().normalised_of({static_cast<double>(u), static_cast<double>(v)});
      const Eigen::Vector3f optical(static_cast<float>(n.sx), static_cast<float>(n.sy), 1.0f);
      const auto hit = renderer.scene().closest_hit(pose.translation(), pose.linear() * optical.normalized());
      const float range = frame.range_m[static_cast<std::size_t>(v) * frame.width + u];
      const float expected = hit ? hit->range_m : kRangeOfNothing_m;
      differ += std::abs(range - expected) > 1e-4f * expected ? 1 : 0;
    }
  return static_cast<double>(differ) / (frame.width * frame.height);
}

RigConfig lens_of(float hfov_deg, float k1) {
  RigConfig rig = test::bare_rig();
  rig.lens.width = 330;  // not a whole number of tiles
  rig.lens.height = 250;
  rig.lens.hfov_deg = hfov_deg;
  rig.lens.k1 = k1;
  return rig;
}

TEST(Sight, EveryPixelSeesWhatItsOwnRayMeets) {
  const World world = splinter_world();
  for (const auto& [hfov_deg, k1] : {std::pair{75.0f, 0.0f}, {110.0f, 0.0f}, {90.0f, -0.12f}}) {
    Renderer renderer(world, lens_of(hfov_deg, k1), test::bare_render());
    Shot shot = test::shot_at({0, 0.3f, 1.2f});
    shot.pose.attitude = Eigen::AngleAxisf(0.3f, Eigen::Vector3f(0.2f, 0.5f, 1.0f).normalized());
    // Rays that graze an edge fall to either side of it by the last bit, and splinters seen nearly edge on have no
    // sharp range. One pixel of 2000; a triangle that is left out would be hundreds.
    EXPECT_LT(share_that_differs(renderer, renderer.render(shot), shot), 5e-4) << hfov_deg << " deg, k1 " << k1;
  }
}

TEST(Sight, NothingSlipsThroughTheSeamsOfAClosedRoom) {
  const World world = test::box_world({-300, -200, -1}, {300, 260, 4});
  Renderer renderer(world, lens_of(100.0f, 0.0f), test::bare_render());
  for (int i = 0; i < 20; ++i) {
    Shot shot = test::shot_at({static_cast<float>(i) * 13.7f - 130.0f, static_cast<float>(i) * 7.3f, 1.0f});
    shot.pose.attitude = Eigen::AngleAxisf(0.37f * static_cast<float>(i), Eigen::Vector3f::UnitZ());
    const Frame frame = renderer.render(shot);
    for (const float range : frame.range_m) ASSERT_LT(range, 1000.0f);
  }
}

/// A tile has one origin, in the middle of its rows, while the shutter rolls and the camera moves: a quarter of a
/// millimetre to either side at 1 m/s. What a pixel sees may then change at edges, but its range is its own ray's.
TEST(Sight, ARollingShutterMovesEdgesByLessThanAPixel) {
  const World world = splinter_world();
  RigConfig rig = lens_of(75.0f, 0.0f);
  rig.sensor.readout_s = 0.025f;
  Renderer renderer(world, rig, test::bare_render());
  Shot shot = test::shot_at({0, 0.3f, 1.2f});
  const Frame still = renderer.render(shot);
  shot.pose.velocity_m_s = {1.0f, 0.0f, 0.0f};
  const Frame moving = renderer.render(shot);
  const int middle = still.height / 2;  // here the moving camera is where the other stands
  int differ = 0;
  for (int u = 0; u < still.width; ++u) {
    const std::size_t i = static_cast<std::size_t>(middle) * still.width + u;
    differ += std::abs(moving.range_m[i] - still.range_m[i]) > 1e-3f * still.range_m[i] ? 1 : 0;
  }
  EXPECT_LE(differ, 3);
}

}  // namespace
}  // namespace adit::sim
