// The door behind the start: nothing gets past it, and the way ahead is as free as before.
#include "adit/sim/door.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "adit/sim/course.hpp"
#include "adit/sim/scene.hpp"
#include "short_drift.hpp"

namespace adit::sim {
namespace {

/// Unit, turned from the start's heading to the left and up.
Eigen::Vector3f direction(const World& world, double left_rad, double up_rad) {
  const double yaw_rad = world.start.yaw_rad + left_rad;
  return Eigen::Vector3d(std::cos(yaw_rad) * std::cos(up_rad), std::sin(yaw_rad) * std::cos(up_rad), std::sin(up_rad))
      .cast<float>();
}

TEST(Door, NoRayGetsPastIt) {
  World world = build_course(short_drift());
  const Eigen::Vector3f eye = world.start.place + Eigen::Vector3f(0.0f, 0.0f, 1.0f);
  const RayScene open(world.mesh);
  const auto out = open.closest_hit(eye, direction(world, M_PI, 0.0));
  ASSERT_TRUE(!out || out->range_m > 2.0f) << "without the door there is a way out";

  close_behind_start(world);
  EXPECT_EQ(world.mesh.triangles.size(), world.mesh.materials.size());
  EXPECT_EQ(world.materials.back().name, "door");
  const RayScene shut(world.mesh);
  int on_door = 0;
  for (double left = M_PI - 1.3; left < M_PI + 1.3; left += 0.1) {
    for (double up = -1.2; up < 1.2; up += 0.1) {
      const Eigen::Vector3f ray = direction(world, left, up);
      const auto hit = shut.closest_hit(eye, ray);
      ASSERT_TRUE(hit) << left << ", " << up;
      const double behind_m = -hit->range_m * ray.dot(direction(world, 0.0, 0.0));
      EXPECT_LE(behind_m, kDoorBehind_m + 1e-4) << left << ", " << up;
      on_door += behind_m > kDoorBehind_m - 1e-4 ? 1 : 0;
    }
  }
  EXPECT_GT(on_door, 50);
}

TEST(Door, TheWayAheadStaysAsItWas) {
  World world = build_course(short_drift());
  const Eigen::Vector3f eye = world.start.place + Eigen::Vector3f(0.0f, 0.0f, 1.0f);
  const RayScene open(world.mesh);
  World with_door = world;
  close_behind_start(with_door);
  const RayScene shut(with_door.mesh);
  for (double left = -1.5; left < 1.5; left += 0.1) {
    const auto before = open.closest_hit(eye, direction(world, left, 0.0), 100.0f);
    const auto after = shut.closest_hit(eye, direction(world, left, 0.0), 100.0f);
    ASSERT_EQ(before.has_value(), after.has_value());
    if (!before) continue;
    EXPECT_EQ(before->range_m, after->range_m);
  }
}

TEST(Door, WhereNoLayoutIsKnownItIsTenMetresWide) {
  World world;
  world.start.place = {3.0f, 2.0f, 1.0f};
  world.start.yaw_rad = static_cast<float>(M_PI / 2.0);
  world.materials.resize(1);
  close_behind_start(world);
  Eigen::Vector3f low = world.mesh.vertices.front(), high = low;
  for (const Eigen::Vector3f& vertex : world.mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  EXPECT_NEAR(high.x() - low.x(), 10.0, 1e-4);
  EXPECT_NEAR(high.z() - low.z(), 8.0, 1e-4);
  EXPECT_NEAR(high.y(), 2.0 - kDoorBehind_m, 1e-4);
  world.materials.resize(255);
  EXPECT_THROW(close_behind_start(world), std::invalid_argument);
}

}  // namespace
}  // namespace adit::sim
