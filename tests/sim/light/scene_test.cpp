#include "adit/sim/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "box.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
using test::box_world;

const Vector3f kLow(0, -3, 0), kHigh(20, 3, 4);

/// Range from inside the box along a unit direction.
float range_in_box(const Vector3f& o, const Vector3f& d) {
  float t = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 3; ++k)
    if (d[k] != 0.0f) t = std::min(t, ((d[k] > 0 ? kHigh[k] : kLow[k]) - o[k]) / d[k]);
  return t;
}

TEST(RayScene, RangesInABoxAreThoseOfGeometry) {
  const RayScene scene(box_world(kLow, kHigh).mesh);
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  const Vector3f origin(5, 0.5f, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3f d = Vector3f(normal(random), normal(random), normal(random)).normalized();
    const auto hit = scene.closest_hit(origin, d);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->range_m, range_in_box(origin, d), 1e-4f);
    EXPECT_LT(hit->normal.dot(d), 0.0f);
    EXPECT_NEAR(hit->normal.cwiseAbs().maxCoeff(), 1.0f, 1e-5f);
  }
  EXPECT_FALSE(scene.closest_hit(origin, Vector3f::UnitX(), 14.9f));
}

TEST(RayScene, PacketsAgreeWithSingleRays) {
  const RayScene scene(box_world(kLow, kHigh).mesh);
  RayPacket rays{};
  HitPacket hits{};
  std::mt19937 random(2);
  std::normal_distribution<float> normal;
  const Vector3f origin(9, -1, 2);
  for (int i = 0; i < kPacket; ++i) {
    const Vector3f d = Vector3f(normal(random), normal(random), normal(random)).normalized();
    for (int k = 0; k < 3; ++k) {
      rays.origin[k][i] = origin[k];
      rays.direction[k][i] = d[k];
    }
    rays.tnear[i] = 0.0f;
    rays.tfar[i] = i == 5 ? -1.0f : 1e9f;
  }
  scene.intersect(rays, hits);
  for (int i = 0; i < kPacket; ++i) {
    const Vector3f d(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    if (i == 5)
      EXPECT_EQ(hits.triangle[i], kNoTriangle);
    else
      EXPECT_NEAR(hits.t[i], range_in_box(origin, d), 1e-4f);
  }
  EXPECT_EQ(scene.occluded(rays), 0xffffu & ~(1u << 5));
}

TEST(RayScene, OcclusionIsSeen) {
  World world = box_world(kLow, kHigh);
  // A wall across the middle that leaves the left half open.
  const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
  for (const Vector3f& v : {Vector3f(10, -3, 0), Vector3f(10, 0, 0), Vector3f(10, 0, 4)})
    world.mesh.vertices.push_back(v);
  world.mesh.triangles.emplace_back(first, first + 1, first + 2);
  world.mesh.materials.push_back(0);
  const RayScene scene(world.mesh);
  EXPECT_TRUE(scene.occluded({5, -1, 1}, {15, -1, 1}));
  EXPECT_FALSE(scene.occluded({5, 1, 1}, {15, 1, 1}));
  EXPECT_FALSE(scene.occluded({5, 1, 0}, {15, 1, 0})) << "the ends' own surfaces do not count";
}

TEST(RayScene, NearestIsTheDistanceToTheSides) {
  const RayScene scene(box_world(kLow, kHigh).mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit;
  for (int i = 0; i < 500; ++i) {
    const Vector3f p = kLow + (kHigh - kLow).cwiseProduct(Vector3f(unit(random), unit(random), unit(random)));
    const float expected = std::min((p - kLow).minCoeff(), (kHigh - p).minCoeff());
    const auto near = scene.nearest(p, 50.0f);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance_m, expected, 1e-4f);
    EXPECT_FALSE(scene.nearest(p, 0.9f * expected));
  }
}

TEST(RayScene, ASphereNeverPassesAWallAtAnySpeed) {
  const RayScene scene(box_world(kLow, kHigh).mesh);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit;
  std::normal_distribution<float> normal;
  int touched = 0;
  for (int i = 0; i < 2000; ++i) {
    const float radius = 0.05f + 0.5f * unit(random);
    const Vector3f margin = Vector3f::Constant(radius + 1e-3f);
    const Vector3f start =
        kLow + margin + (kHigh - kLow - 2 * margin).cwiseProduct(Vector3f(unit(random), unit(random), unit(random)));
    const float length = std::pow(10.0f, -3.0f + 5.0f * unit(random));  // 1 mm to 100 m a step
    const Vector3f end = start + length * Vector3f(normal(random), normal(random), normal(random)).normalized();
    const bool leaves = ((end - kLow).array() < radius).any() || ((kHigh - end).array() < radius).any();
    const auto contact = scene.first_contact(start, end, radius);
    if (leaves) {
      ASSERT_TRUE(contact) << start.transpose() << " to " << end.transpose();
    }
    if (!contact) continue;
    ++touched;
    EXPECT_GE((contact->centre - kLow).minCoeff(), radius - 1e-4f);
    EXPECT_GE((kHigh - contact->centre).minCoeff(), radius - 1e-4f);
    EXPECT_NEAR((contact->place - contact->centre).norm(), radius, 2.1e-4f);
    EXPECT_NEAR((start + (end - start) * contact->fraction - contact->centre).norm(), 0.0f, 1e-4f * (1 + length));
  }
  EXPECT_GT(touched, 300);
}

TEST(RayScene, AFanOfHorizontalRays) {
  const RayScene scene(box_world(kLow, kHigh).mesh);
  const std::vector<float> angles = {0.0f, 1.5707963f, 3.1415927f, -1.5707963f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f};
  const auto ranges = scene.horizontal_ranges_m({5, 1, 1}, 0.0f, angles, 12.0f);
  ASSERT_EQ(ranges.size(), angles.size());
  EXPECT_FLOAT_EQ(ranges[0], 12.0f);
  EXPECT_NEAR(ranges[1], 2.0f, 1e-4f);
  EXPECT_NEAR(ranges[2], 5.0f, 1e-4f);
  EXPECT_NEAR(ranges[3], 4.0f, 1e-4f);
  EXPECT_NEAR(ranges[8], 2.0f / std::sin(0.5f), 1e-3f);
}

TEST(RayScene, BadMeshesAreRefusedByName) {
  World world = box_world(kLow, kHigh);
  EXPECT_THROW(RayScene(Mesh{}), std::invalid_argument);
  Mesh nan = world.mesh;
  nan.vertices[3].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(RayScene{nan}, std::invalid_argument);
  Mesh index = world.mesh;
  index.triangles[2][1] = 8;
  EXPECT_THROW(RayScene{index}, std::invalid_argument);
  Mesh materials = world.mesh;
  materials.materials.pop_back();
  EXPECT_THROW(RayScene{materials}, std::invalid_argument);
}

}  // namespace
}  // namespace adit::sim
