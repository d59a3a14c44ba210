#include "adit/sim/network.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Passage straight(int from, int to, const std::vector<Node>& nodes) {
  const Vector3f a = nodes[static_cast<std::size_t>(from)].place, b = nodes[static_cast<std::size_t>(to)].place;
  Passage passage{from, to, {}};
  for (int i = 0; i <= 20; ++i) passage.axis.push_back({a + (b - a) * (static_cast<float>(i) / 20.0f), 4.0f, 3.0f});
  return passage;
}

/// A stem of 20 m to a junction; left 10 m to a dead end, right 30 m to the goal.
World t_world() {
  World world;
  world.nodes = {{NodeKind::kMouth, {0, 0, 0}},
                 {NodeKind::kJunction, {20, 0, 0}},
                 {NodeKind::kDeadEnd, {20, 10, 0}},
                 {NodeKind::kGoal, {20, -30, 0}}};
  world.passages = {straight(0, 1, world.nodes), straight(2, 1, world.nodes), straight(1, 3, world.nodes)};
  return world;
}

TEST(Network, KnowsWhereOneIsAndTheWayToTheGoal) {
  const Network network(t_world());
  ASSERT_TRUE(network.has_goal());
  const AxisPlace here = network.nearest({12.3, 0.7, 1.0});
  EXPECT_EQ(here.passage, 0);
  EXPECT_NEAR(here.along_m, 12.3, 1e-5);
  EXPECT_NEAR(here.aside_m, 0.7, 1e-5);
  EXPECT_NEAR(network.to_goal_m(here), 7.7 + 30.0, 1e-5);
  EXPECT_NEAR(network.to_goal_m(network.nearest({20, 6, 1})), 36.0, 1e-5);
  EXPECT_NEAR(network.to_goal_m(network.nearest({20, -28, 1})), 2.0, 1e-5);
  EXPECT_NEAR(network.between_m(network.nearest({2, 0, 1}), network.nearest({20, 5, 1})), 23.0, 1e-5);
  EXPECT_NEAR(network.between_m(network.nearest({2, 0, 1}), network.nearest({9, 0, 1})), 7.0, 1e-5);
}

TEST(Network, LooksAheadIntoEveryBranchAndNeverBack) {
  const Network network(t_world());
  const AxisPlace here = network.nearest({18, 0, 1});
  const auto ahead = network.ahead(here, Vector3d::UnitX(), 5.0);
  ASSERT_EQ(ahead.size(), 2u);
  EXPECT_NEAR((ahead[0].place - Vector3d(20, 3, 0)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((ahead[1].place - Vector3d(20, -3, 0)).norm(), 0.0, 1e-5);
  EXPECT_EQ(ahead[0].passage, 1);
  const auto back = network.ahead(here, -Vector3d::UnitX(), 5.0);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_NEAR((back[0].place - Vector3d(13, 0, 0)).norm(), 0.0, 1e-5);
  // Into the dead end: the way ends there and says so.
  const auto end = network.ahead(network.nearest({20, 8, 1}), Vector3d::UnitY(), 5.0);
  ASSERT_EQ(end.size(), 1u);
  EXPECT_TRUE(end[0].at_end);
  EXPECT_EQ(end[0].end, NodeKind::kDeadEnd);
}

TEST(Network, BranchesAreSeenFromAfar) {
  const Network network(t_world());
  const AxisPlace here = network.nearest({8, 0, 1});
  EXPECT_TRUE(network.branches(here, Vector3d::UnitX(), 11.0, 2.0).empty());
  const auto found = network.branches(here, Vector3d::UnitX(), 13.0, 2.0);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR((found[0].place - Vector3d(20, 4, 0)).norm(), 0.0, 1e-5);
}

TEST(Network, AMouthIsItsEnd) {
  const Network network(t_world());
  EXPECT_TRUE(network.is_mouth(network.nearest({-4, 0, 1})));
  EXPECT_FALSE(network.is_mouth(network.nearest({0.5, 0, 1})));
  EXPECT_FALSE(network.is_mouth(network.nearest({20, 15, 1})));
}

TEST(Network, WorldsWithoutALayoutAndBrokenOnes) {
  EXPECT_TRUE(Network(World{}).empty());
  World broken = t_world();
  broken.passages[0].to = 17;
  broken.passages[1].axis.resize(1);
  const Network network(broken);
  EXPECT_FALSE(network.empty());
  EXPECT_EQ(network.nearest({0, 0, 0}).passage, 0);
}

TEST(Network, ARingDoesNotRunOnForEver) {
  World ring;
  ring.nodes = {{NodeKind::kBend, {0, 0, 0}}, {NodeKind::kBend, {1, 0, 0}}, {NodeKind::kBend, {0, 1, 0}}};
  ring.passages = {straight(0, 1, ring.nodes), straight(1, 2, ring.nodes), straight(2, 0, ring.nodes)};
  const Network network(ring);
  EXPECT_EQ(network.ahead(network.nearest({0.5, 0, 0}), Vector3d::UnitX(), 1000.0).size(), 1u);
  EXPECT_TRUE(std::isinf(network.to_goal_m(network.nearest({0.5, 0, 0}))));
}

}  // namespace
}  // namespace adit::sim
