// Shadows of lamps beside the lens: rays go only where the lamp's parallax lays something over a place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bare_rig.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

/// A room with pillars of several widths, some of them close.
World pillars() {
  World world = test::box_world({-1, -4, 0}, {14, 4, 4}, 0.3f);
  const auto add = [&world](float x, float y, float half_width) {
    const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
    for (const float side : {-1.0f, 1.0f})
      for (const float z : {0.0f, 4.0f}) world.mesh.vertices.emplace_back(x, y + side * half_width, z);
    world.mesh.triangles.emplace_back(first, first + 2, first + 1);
    world.mesh.triangles.emplace_back(first + 1, first + 2, first + 3);
    world.mesh.materials.insert(world.mesh.materials.end(), 2, std::uint8_t{0});
  };
  add(4, -1.2f, 0.15f);
  add(5, 0.9f, 0.3f);
  add(7, 0.1f, 0.1f);
  add(9, -2.5f, 0.4f);
  return world;
}

/// @param aside_m, up_m  of the one lamp from the lens.
RigConfig rig_with_lamp(float aside_m, float up_m, float k1) {
  RigConfig rig = test::bare_rig();
  rig.lens.width = 200;
  rig.lens.height = 150;
  rig.lens.k1 = k1;
  rig.lamps.lamps.resize(1);
  rig.lamps.lamps[0].forward_m = 0.0f;
  rig.lamps.lamps[0].left_m = aside_m;
  rig.lamps.lamps[0].up_m = up_m;
  return rig;
}

/// Whether a ray from the lamp says otherwise than the picture, for each pixel but those at the very edge of a shadow.
struct Compared {
  int dark = 0, wrong = 0;
};

Compared compared(const World& world, const RigConfig& rig) {
  Renderer renderer(world, rig, test::bare_render());
  const Shot shot = test::shot_at({0.5f, 0.0f, 1.5f});
  const Radiance radiance = renderer.radiance(shot);
  const Frame frame = renderer.render(shot);
  const Eigen::Isometry3f pose = renderer.camera_pose(shot.pose);
  const Lamp& lamp = rig.lamps.lamps[0];
  const Eigen::Vector3f from = shot.pose.place + Eigen::Vector3f(lamp.forward_m, lamp.left_m, lamp.up_m);
  std::vector<int> is_dark(radiance.green.size());
  for (int v = 0; v < frame.height; ++v)
    for (int u = 0; u < frame.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * frame.width + u;
      const NormalisedPoint n = renderer.camera().normalised_of({static_cast<double>(u), static_cast<double>(v)});
      const Eigen::Vector3f ray =
          Eigen::Vector3f(static_cast<float>(n.sx), static_cast<float>(n.sy), 1.0f).normalized();
      const Eigen::Vector3f place = pose * (ray * (frame.range_m[i] - 5e-3f));
      is_dark[i] = renderer.scene().occluded(from, place) ? 1 : 0;
    }
  Compared result;
  for (int v = 1; v + 1 < frame.height; ++v)
    for (int u = 1; u + 1 < frame.width; ++u) {
      int around = 0;
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) around += is_dark[static_cast<std::size_t>(v + dv) * frame.width + u + du];
      const bool dark = around == 9;
      if (!dark && around != 0) continue;
      const bool shown = radiance.green[static_cast<std::size_t>(v) * frame.width + u] <= 0.0f;
      result.dark += dark ? 1 : 0;
      result.wrong += shown != dark ? 1 : 0;
    }
  return result;
}

TEST(Shadow, OfALampBesideTheLensLiesWhereRaysSay) {
  const World world = pillars();
  for (const auto& [aside_m, up_m, k1] :
       {std::tuple{0.18f, -0.05f, 0.0f}, {-0.25f, 0.0f, 0.0f}, {0.0f, 0.2f, 0.0f}, {0.1f, 0.15f, -0.1f}}) {
    const Compared result = compared(world, rig_with_lamp(aside_m, up_m, k1));
    EXPECT_LE(result.wrong, 15) << "of 30000; lamp at " << aside_m << ", " << up_m << ", k1 " << k1;
    // Pillars reach from floor to roof: a lamp straight above or below the lens shows none of their shadows.
    EXPECT_GT(result.dark, aside_m != 0.0f ? 20 : -1) << aside_m;
  }
}

TEST(Shadow, CanBeLeftOut) {
  const World world = pillars();
  RenderConfig render = test::bare_render();
  const Shot shot = test::shot_at({0.5f, 0.0f, 1.5f});
  const RigConfig rig = rig_with_lamp(0.18f, 0.0f, 0.0f);
  const Radiance with = Renderer(world, rig, render).radiance(shot);
  render.shadows = false;
  const Radiance without = Renderer(world, rig, render).radiance(shot);
  EXPECT_GT(std::count(with.green.begin(), with.green.end(), 0.0f), 200);
  EXPECT_EQ(std::count(without.green.begin(), without.green.end(), 0.0f), 0);
}

}  // namespace
}  // namespace adit::sim
