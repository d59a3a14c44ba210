#include "adit/sim/vehicle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "adit/sim/flight_fields.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const Vector3f kLow(-50, -50, 0), kHigh(50, 50, 40);

VehicleConfig calm() {
  VehicleConfig config;
  config.gust_sigma_m_s = 0.0;
  config.yaw_rate_noise_rad_s = 0.0;
  config.height_noise_m = 0.0;
  return config;
}

class VehicleTest : public testing::Test {
 protected:
  World world_ = test::box_world(kLow, kHigh);
  RayScene scene_{world_.mesh};
};

TEST_F(VehicleTest, SpeedAndWayFollowTheirClosedFormsAtAnyStep) {
  for (const double step_s : {0.001, 0.005, 0.02, 0.1}) {
    Vehicle vehicle(calm(), scene_, {}, 1);
    const double lag_s = vehicle.config().velocity_lag_s;
    double time_s = 0.0;
    while (time_s < 2.0 - 1e-9) {
      ASSERT_FALSE(vehicle.step({2.0, 0.0}, step_s));
      time_s += step_s;
      const double left = std::exp(-time_s / lag_s);
      ASSERT_NEAR(vehicle.state().velocity.x(), 2.0 * (1.0 - left), 1e-9);
      ASSERT_NEAR(vehicle.state().place.x(), 2.0 * (time_s - lag_s * (1.0 - left)), 1e-9);
    }
    EXPECT_NEAR(vehicle.state().place.y(), 0.0, 1e-12);
  }
}

TEST_F(VehicleTest, YawRateFollowsItsClosedForm) {
  Vehicle vehicle(calm(), scene_, {{0, 0, 0}, 1.0f}, 1);
  const double lag_s = vehicle.config().yaw_rate_lag_s;
  for (int i = 1; i <= 300; ++i) {
    ASSERT_FALSE(vehicle.step({0.0, 0.5}, 0.005));
    const double left = std::exp(-i * 0.005 / lag_s);
    ASSERT_NEAR(vehicle.state().yaw_rate_rad_s, 0.5 * (1.0 - left), 1e-9);
    ASSERT_NEAR(vehicle.state().yaw_rad, 1.0 + 0.5 * (i * 0.005 - lag_s * (1.0 - left)), 1e-7);
  }
}

TEST_F(VehicleTest, ATurnIsACircleWithTheSlipOfTheLag) {
  // Steady: v lags R(yaw) u by the transfer 1/(1 + i w T): speed u/sqrt(1 + (wT)^2), slip atan(wT).
  Vehicle vehicle(calm(), scene_, {}, 1);
  const double lag_s = vehicle.config().velocity_lag_s;
  for (int i = 0; i < 4000; ++i) ASSERT_FALSE(vehicle.step({1.5, 0.6}, 0.005));
  const VehicleState& s = vehicle.state();
  const double expected = 1.5 / std::hypot(1.0, 0.6 * lag_s);
  EXPECT_NEAR(s.velocity.head<2>().norm(), expected, 1e-3);
  const double course = std::atan2(s.velocity.y(), s.velocity.x());
  EXPECT_NEAR(std::remainder(s.yaw_rad - course, 2 * std::numbers::pi), std::atan(0.6 * lag_s), 2e-3);
  // It banks into the turn: to the left is a negative roll.
  EXPECT_LT(s.roll_rad, -0.05);
}

TEST_F(VehicleTest, TiltsForwardToAccelerateAndAgainstDragAndBackToBrake) {
  Vehicle vehicle(calm(), scene_, {}, 1);
  for (int i = 0; i < 40; ++i) vehicle.step({2.0, 0.0}, 0.005);
  EXPECT_GT(vehicle.state().pitch_rad, 0.15);
  for (int i = 0; i < 2000; ++i) vehicle.step({2.0, 0.0}, 0.005);
  EXPECT_NEAR(vehicle.state().pitch_rad, std::atan2(vehicle.config().drag_1_s * 2.0, kGravity_m_s2), 1e-4);
  for (int i = 0; i < 40; ++i) vehicle.step({0.0, 0.0}, 0.005);
  EXPECT_LT(vehicle.state().pitch_rad, -0.1);
  EXPECT_NEAR(vehicle.state().roll_rad, 0.0, 1e-9);
  // Nose down is a positive pitch: the body's x axis points below the horizon.
  VehicleState down;
  down.pitch_rad = 0.2;
  EXPECT_LT((down.attitude() * Vector3d::UnitX()).z(), -0.1);
}

TEST_F(VehicleTest, RestsWithGravityUpAndNoTilt) {
  Vehicle vehicle(calm(), scene_, {}, 1);
  for (int i = 0; i < 100; ++i) vehicle.step({}, 0.005);
  EXPECT_NEAR((vehicle.specific_force() - kGravity_m_s2 * Vector3d::UnitZ()).norm(), 0.0, 1e-6);
}

TEST_F(VehicleTest, KeepsItsHeightOverAFloorThatClimbs) {
  World ramp = test::box_world({-5, -5, -20}, {200, 5, 60}, 0.3f, 16);
  const auto first = static_cast<std::uint32_t>(ramp.mesh.vertices.size());
  for (const Vector3f& v :
       {Vector3f(-5, -5, -1.25f), Vector3f(200, -5, 50), Vector3f(200, 5, 50), Vector3f(-5, 5, -1.25f)})
    ramp.mesh.vertices.push_back(v);  // 1:4
  ramp.mesh.triangles.emplace_back(first, first + 1, first + 2);
  ramp.mesh.triangles.emplace_back(first, first + 2, first + 3);
  ramp.mesh.materials.insert(ramp.mesh.materials.end(), 2, std::uint8_t{0});
  const RayScene scene(ramp.mesh);
  Vehicle vehicle(calm(), scene, {}, 1);
  EXPECT_NEAR(vehicle.state().place.z(), 1.0, 1e-4);
  for (int i = 0; i < 4000; ++i) ASSERT_FALSE(vehicle.step({1.0, 0.0}, 0.005));
  // Steady on a ramp: climb 0.25 m/s = gain * error (plus what the filter trails behind: it trails nothing, steadily).
  const double over = vehicle.state().place.z() - 0.25 * vehicle.state().place.x();
  EXPECT_NEAR(over, 1.0 - 0.25 / vehicle.config().height_gain_1_s, 0.01);
}

TEST_F(VehicleTest, GustsHaveTheirDeviationAndPushTheVehicle) {
  GaussMarkov gust(0.5, 1.0);
  Random random(5);
  double squares = 0.0, lagged = 0.0, before = 0.0;
  const int n = 400000;
  for (int i = 0; i < n; ++i) {
    const double x = gust.step(0.05, random.normal());
    squares += x * x;
    lagged += x * before;
    before = x;
  }
  EXPECT_NEAR(std::sqrt(squares / n), 0.5, 0.02);
  EXPECT_NEAR(lagged / squares, std::exp(-0.05), 0.002);

  VehicleConfig windy = calm();
  windy.gust_sigma_m_s = 2.0;
  Vehicle a(windy, scene_, {}, 1), b(windy, scene_, {}, 1), c(windy, scene_, {}, 2);
  for (int i = 0; i < 1000; ++i) {
    a.step({}, 0.005);
    b.step({}, 0.005);
    c.step({}, 0.005);
  }
  EXPECT_GT(a.state().place.head<2>().norm(), 0.01);
  EXPECT_EQ(a.state().place, b.state().place);
  EXPECT_NE(a.state().place, c.state().place);
}

TEST_F(VehicleTest, NeverPassesAWallAtAnySpeedAndStep) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit;
  const Vector3f low(-4, -3, 0), high(4, 3, 4);
  const World room = test::box_world(low, high);
  const RayScene scene(room.mesh);
  int touched = 0;
  for (int flight = 0; flight < 300; ++flight) {
    VehicleConfig config;
    config.body_radius_m = 0.05 + 0.4 * unit(random);
    config.gust_sigma_m_s = 10.0 * unit(random);
    config.velocity_lag_s = unit(random);
    config.height_m = 0.5 + 3.0 * unit(random);
    const double speed_m_s = std::pow(10.0, -1.0 + 4.0 * unit(random));  // 0.1 to 1000 m/s
    const double step_s = std::pow(10.0, -3.0 + 3.0 * unit(random));     // 1 ms to 1 s
    const StartPose start{{0, 0, 0}, static_cast<float>(6.283 * unit(random))};
    Vehicle vehicle(config, scene, start, static_cast<std::uint64_t>(flight));
    for (int i = 0; i < 300; ++i) {
      const auto contact = vehicle.step({speed_m_s, 4.0 * unit(random) - 2.0}, step_s);
      const Vector3f p = vehicle.state().place.cast<float>();
      ASSERT_GE((p - low).minCoeff(), config.body_radius_m - 1e-3) << "speed " << speed_m_s << ", step " << step_s;
      ASSERT_GE((high - p).minCoeff(), config.body_radius_m - 1e-3) << "speed " << speed_m_s << ", step " << step_s;
      if (!contact) continue;
      ++touched;
      break;
    }
  }
  EXPECT_GT(touched, 200);
}

TEST_F(VehicleTest, AStartInRockAndABadFieldAreRefusedByName) {
  try {
    Vehicle(VehicleConfig{}, scene_, {{49.9f, 0, 0}, 0.0f}, 1);
    FAIL() << "a start in the wall was taken";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("body_radius_m"), std::string::npos);
  }
  VehicleConfig bad;
  bad.height_m = std::nan("");
  const auto fault = fault_of(bad);
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault, "height_m: nan is not in 0.1 to 20 m");
  EXPECT_FALSE(fault_of(VehicleConfig{}));
}

}  // namespace
}  // namespace adit::sim
