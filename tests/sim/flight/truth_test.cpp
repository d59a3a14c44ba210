#include "adit/sim/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bent_tunnel.hpp"
#include "box.hpp"
#include "stand_in.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;

VehicleState standing(const Vector3d& place, double yaw_rad) {
  VehicleState state;
  state.place = place;
  state.yaw_rad = yaw_rad;
  return state;
}

Vector3d nose(const VehicleState& s) { return {std::cos(s.yaw_rad), std::sin(s.yaw_rad), 0.0}; }

TEST(Truth, BearingsArePositiveToTheRightAndUp) {
  const World box = test::box_world({-5, -5, 0}, {50, 5, 4});
  const RayScene scene(box.mesh);
  const test::StandIn eye(scene);
  const VehicleState state = standing({0, 0, 1}, 0.3);
  // A point ahead, to the right of the nose by 10 degrees and higher by 5.
  const double yaw = 0.3 - 10 * kDegree;
  const Vector3d point = state.place + 7.0 * Vector3d(std::cos(yaw), std::sin(yaw), std::tan(5 * kDegree));
  const Bearing bearing = bearing_to(eye.pose(state), point);
  EXPECT_NEAR(bearing.azimuth_rad, 10 * kDegree, 1e-9);
  EXPECT_NEAR(bearing.elevation_rad, 5 * kDegree, 1e-9);
  // The same convention as the core's: the pixel of that bearing is right of the middle and above it.
  const auto pixel = eye.camera().pixel_of(bearing);
  ASSERT_TRUE(pixel);
  EXPECT_GT(pixel->u_px, 40.0);
  EXPECT_LT(pixel->v_px, 30.0);
}

TEST(Truth, RangeImageOfABoxInClosedForm) {
  const World box = test::box_world({-5, -2, 0}, {20, 2, 3});
  const RayScene scene(box.mesh);
  const test::StandIn eye(scene, 41, 31);
  const auto image = range_image_m(scene, eye.camera(), eye.pose(standing({0, 0, 1}, 0.0)), 100.0f);
  ASSERT_EQ(image.size(), 41u * 31u);
  EXPECT_NEAR(image[15 * 41 + 20], 20.0f, 1e-3f);  // the middle pixel looks along the axis
  const NormalisedPoint corner = eye.camera().normalised_of({0.0, 15.0});
  EXPECT_NEAR(image[15 * 41], 2.0 / std::abs(corner.sx) * std::hypot(1.0, corner.sx), 1e-3);
}

TEST(Truth, ClearanceOfABox) {
  const World box = test::box_world({-5, -2, 0}, {20, 2, 3});
  const RayScene scene(box.mesh);
  const test::StandIn eye(scene);
  const Network none;
  const Surveyor surveyor({}, scene, none, 75.0);
  const VehicleState state = standing({4, 0.8, 1}, 0.2);
  const Truth truth = surveyor.look(state.place, nose(state), eye.pose(state), 1.0, std::nullopt);
  EXPECT_NEAR(truth.clearance_m, 1.0, 1e-4) << "the floor";
  EXPECT_NEAR(truth.side_clearance_m, 1.2, 1e-3) << "the wall";
  EXPECT_TRUE(std::isnan(truth.progress_m));
}

TEST(Truth, DeepestDirectionAndGapOfATunnel) {
  const World box = test::box_world({-5, -2, 0}, {40, 2, 3});
  const RayScene scene(box.mesh);
  const test::StandIn eye(scene);
  const Network none;
  const Surveyor surveyor({}, scene, none, 75.0);
  for (const double yaw : {0.0, 0.35, -0.3}) {
    const VehicleState state = standing({0, 0.0, 1.5}, yaw);
    const Truth truth = surveyor.look(state.place, nose(state), eye.pose(state), 1.0, std::nullopt);
    // The end of the tunnel lies along +x: to the right of a nose that is turned to the left.
    EXPECT_NEAR(truth.deepest.azimuth_rad, yaw, 1.1 * kDegree);
    EXPECT_GT(truth.deepest_range_m, 20.0);
    EXPECT_TRUE(truth.opening_in_sight);
    EXPECT_NEAR(truth.passage.azimuth_rad, yaw, 1.5 * kDegree);
  }
  const VehicleState at_wall = standing({0, 0.0, 1.5}, 0.5 * std::numbers::pi);
  const Truth wall = surveyor.look(at_wall.place, nose(at_wall), eye.pose(at_wall), 1.0, std::nullopt);
  EXPECT_FALSE(wall.opening_in_sight);
  EXPECT_LT(wall.deepest_range_m, 4.0);
}

TEST(Truth, PassageAheadGoesAroundTheCorner) {
  const World bent = test::bent_tunnel({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {20, 30, 0}}, 4, 3);
  const RayScene scene(bent.mesh);
  const Network network(bent);
  const test::StandIn eye(scene);
  const Surveyor surveyor({}, scene, network, 75.0);
  const std::optional<AxisPlace> start = network.nearest(Vector3d(3, 0, 1));
  const VehicleState state = standing({18, 0, 1}, 0.0);
  const Truth truth = surveyor.look(state.place, nose(state), eye.pose(state), 1.0, start);
  EXPECT_NEAR(truth.passage.azimuth_rad, -std::atan2(3.0, 2.0), 1e-6) << "2 m on, 3 m to the left";
  EXPECT_NEAR(truth.progress_m, 15.0, 1e-5);
  EXPECT_NEAR(truth.to_goal_m, 22.0, 1e-5);
  EXPECT_NEAR(truth.aside_m, 0.0, 1e-5);
  EXPECT_EQ(truth.branches.size(), 1u);
}

Passage straight(int from, int to, const World& world) {
  const Eigen::Vector3f a = world.nodes[static_cast<std::size_t>(from)].place;
  const Eigen::Vector3f b = world.nodes[static_cast<std::size_t>(to)].place;
  Passage passage{from, to, {}};
  for (int i = 0; i <= 20; ++i) passage.axis.push_back({a + (b - a) * (static_cast<float>(i) / 20.0f), 4.0f, 3.0f});
  return passage;
}

TEST(Truth, WayToAJunctionIsNoBranchOfIt) {
  // A T in a hall, so that all of it can be seen: the stem ends at x = 20 m, 15 m ahead.
  World world = test::bent_tunnel({{0, 0, 0}, {40, 0, 0}}, 30, 3);
  world.nodes = {{NodeKind::kMouth, {0, 0, 0}},
                 {NodeKind::kJunction, {20, 0, 0}},
                 {NodeKind::kGoal, {20, 14, 0}},
                 {NodeKind::kGoal, {20, -14, 0}}};
  world.passages = {straight(0, 1, world), straight(1, 2, world), straight(1, 3, world)};
  const RayScene scene(world.mesh);
  const Network network(world);
  const test::StandIn eye(scene);
  const Surveyor surveyor({}, scene, network, 75.0);
  const VehicleState state = standing({5, 0, 1}, 0.0);
  const Truth truth = surveyor.look(state.place, nose(state), eye.pose(state), 1.0, std::nullopt);
  EXPECT_NEAR(truth.passage.azimuth_rad, 0.0, 1e-6) << "the stem is followed";
  ASSERT_EQ(truth.branches.size(), 2u) << "left and right";
  EXPECT_NEAR(std::abs(truth.branches[0].azimuth_rad), std::atan2(4.0, 15.0), 1e-6);
  EXPECT_NEAR(truth.branches[0].azimuth_rad, -truth.branches[1].azimuth_rad, 1e-6);
}

}  // namespace
}  // namespace adit::sim
