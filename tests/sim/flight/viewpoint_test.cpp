// Places for data sets: along the passages, or by a walk where no layout is known.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "adit/sim/viewpoints.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

/// An L of two rooms with no layout, the start in the first: who walks far enough turns the corner.
World corner() {
  World world = test::box_world({0, -2, 0}, {12, 2, 3}, 0.3f, 8u);
  // The side at +y is open from x 8 to 12: the rest of it, then the second room.
  const auto add = [&world](const World& more) {
    const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
    world.mesh.vertices.insert(world.mesh.vertices.end(), more.mesh.vertices.begin(), more.mesh.vertices.end());
    for (const auto& t : more.mesh.triangles)
      world.mesh.triangles.emplace_back(t[0] + first, t[1] + first, t[2] + first);
    world.mesh.materials.insert(world.mesh.materials.end(), more.mesh.materials.begin(), more.mesh.materials.end());
  };
  add(test::box_world({0, 2, 0}, {8, 3, 3}, 0.3f, 1u | 2u | 8u | 16u | 32u));  // the wall at y 2
  add(test::box_world({8, 2, 0}, {12, 12, 3}, 0.3f, 4u));
  world.start.place = {1.5f, 0, 0};
  world.start.yaw_rad = 0.0f;
  return world;
}

TEST(Viewpoints, AWalkStaysFreeOverTheFloorAndTurnsTheCorner) {
  const World world = corner();
  const RayScene scene(world.mesh);
  const ViewpointConfig config;
  const ViewpointSource source(config, world, scene, 5);
  int beyond = 0, at_start = 0;
  for (std::int64_t frame = 0; frame < 200; ++frame) {
    const VehicleState v = source.draw(frame);
    EXPECT_FALSE(scene.nearest(v.place.cast<float>(), static_cast<float>(config.free_radius_m))) << frame;
    EXPECT_GE(v.place.z(), config.above_floor_min_m - 1e-6);
    EXPECT_LE(v.place.z(), config.above_floor_max_m + 1e-6);
    EXPECT_NEAR(v.place.z(), v.height_m, 1e-4) << "the floor is at 0";
    EXPECT_GT(v.place.x(), 0.0);
    EXPECT_LT(v.place.x(), 12.0);
    EXPECT_LE(v.velocity.norm(), config.view_speed_max_m_s);
    beyond += v.place.y() > 3.0 ? 1 : 0;
    at_start += (v.place.head<2>() - Eigen::Vector2d(1.5, 0)).norm() < 0.5 ? 1 : 0;
  }
  EXPECT_GT(beyond, 20) << "the second room is seen";
  EXPECT_LT(at_start, 50) << "and most walks leave the start";
}

TEST(Viewpoints, AFrameIsTheSameWhateverIsDrawnBefore) {
  const World world = corner();
  const RayScene scene(world.mesh);
  const ViewpointSource source({}, world, scene, 5), other_seed({}, world, scene, 6);
  const VehicleState seventh = source.draw(7);
  std::set<double> places;
  for (std::int64_t frame = 0; frame < 20; ++frame) places.insert(source.draw(frame).place.x());
  EXPECT_GT(places.size(), 15u);
  EXPECT_EQ(source.draw(7).place, seventh.place);
  EXPECT_NE(other_seed.draw(7).place, seventh.place);
}

TEST(Viewpoints, NoFreePlaceSaysWhatToChange) {
  const World world = test::box_world({0, -1, 0}, {2, 1, 1}, 0.3f);
  const RayScene scene(world.mesh);
  ViewpointConfig config;
  config.free_radius_m = 1.5;
  config.above_floor_max_m = 0.9;
  const ViewpointSource source(config, world, scene, 1);
  try {
    (void)source.draw(3);
    FAIL() << "there is no room";
  } catch (const NoFreePlace& e) {
    EXPECT_NE(std::string(e.what()).find("frame 3"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("free_radius_m"), std::string::npos) << e.what();
  }
  config.above_floor_max_m = 0.1;
  EXPECT_THROW(ViewpointSource(config, world, scene, 1), std::invalid_argument);
}

}  // namespace
}  // namespace adit::sim
