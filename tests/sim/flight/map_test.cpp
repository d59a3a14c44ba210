#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "adit/sim/lidar.hpp"
#include "adit/sim/occupancy.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

TEST(Lidar, RangesOfABoxWithTheirNoise) {
  const World box = test::box_world({-10, -10, 0}, {10, 10, 4});
  const RayScene scene(box.mesh);
  LidarConfig config;
  Lidar lidar(config, scene, 1);
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (int sweep = 0; sweep < 50; ++sweep) {
    const Scan scan = lidar.sweep({0, 0, 1}, Quaterniond::Identity(), 0.1 * sweep);
    ASSERT_EQ(scan.ranges_m.size(), 541u);
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
      const double angle = scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
      const double truth = 10.0 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      const double error = static_cast<double>(scan.ranges_m[i]) - truth;
      sum += error;
      squares += error * error;
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 5.0 * config.lidar_noise_m / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), config.lidar_noise_m, 0.001);
}

TEST(Lidar, NothingWithinRangeIsInfinity) {
  const World box = test::box_world({-10, -10, 0}, {10, 10, 4});
  const RayScene scene(box.mesh);
  LidarConfig config;
  config.lidar_range_max_m = 9.0;
  Lidar lidar(config, scene, 1);
  for (const float range_m : lidar.sweep({0, 0, 1}, Quaterniond::Identity(), 0.0).ranges_m)
    EXPECT_TRUE(std::isinf(range_m));
}

TEST(Imu, NoiseGrowsWithTheBandAndTheBiasStays) {
  ImuConfig config;
  config.gyro_bias_rad_s = 0.0;
  config.accelerometer_bias_m_s2 = 0.5;
  Imu imu(config, 9);
  const int n = 20000;
  double gyro_squares = 0.0;
  Vector3d force = Vector3d::Zero();
  for (int i = 0; i < n; ++i) {
    const ImuSample sample = imu.sample(Vector3d::Zero(), {0, 0, 9.8}, 0.005 * i, 0.005);
    gyro_squares += sample.angular_rate_rad_s.squaredNorm() / 3.0;
    force += sample.specific_force_m_s2;
  }
  EXPECT_NEAR(std::sqrt(gyro_squares / n), config.gyro_noise_rad_s_rthz * std::sqrt(200.0), 2e-5);
  const Vector3d bias = force / n - Vector3d(0, 0, 9.8);
  EXPECT_GT(bias.norm(), 0.05);
  EXPECT_LT(bias.norm(), 2.0);
}

TEST(OccupancyGrid, IsTheBoxItWasScannedFrom) {
  const World box = test::box_world({-4, -3, 0}, {6, 5, 3});
  const RayScene scene(box.mesh);
  LidarConfig config;
  config.lidar_noise_m = 0.0;
  config.lidar_fov_deg = 359.0;
  config.lidar_rays = 2000;
  Lidar lidar(config, scene, 1);
  OccupancyGrid grid(0.1);
  for (int i = 0; i < 10; ++i) {
    const Vector3d place(0.13 * i, 0.07 * i, 1.0);
    const Quaterniond attitude(Eigen::AngleAxisd(0.6 * i, Vector3d::UnitZ()));
    grid.add(lidar.sweep(place, attitude, 0.1 * i), place, attitude);
  }
  for (double x = -3.75; x < 6; x += 0.5)
    for (double y = -2.75; y < 5; y += 0.5) EXPECT_LT(grid.probability_at(x, y), 0.2) << x << ", " << y;
  // The walls lie on a cell's border: rounding puts them into the cell on either side.
  const auto wall = [&grid](double x, double y, double dx, double dy) {
    return std::max(grid.probability_at(x - dx, y - dy), grid.probability_at(x + dx, y + dy));
  };
  int occupied = 0, looked = 0;
  for (double t = -2.75; t < 4.8; t += 0.1, looked += 2)
    occupied += (wall(-4, t, 0.05, 0) > 0.8) + (wall(6, t, 0.05, 0) > 0.8);
  for (double t = -3.75; t < 5.8; t += 0.1, looked += 2)
    occupied += (wall(t, -3, 0, 0.05) > 0.8) + (wall(t, 5, 0, 0.05) > 0.8);
  EXPECT_GT(occupied, looked * 98 / 100);
  EXPECT_DOUBLE_EQ(grid.probability_at(9, 9), 0.5);
  const OccupancyPicture picture = grid.picture();
  EXPECT_NEAR(picture.width, 100, 2);
  EXPECT_NEAR(picture.height, 80, 2);
  EXPECT_NEAR(picture.x_min_m, -4.0, 0.16);
}

TEST(OccupancyGrid, AnEmptyMapIsAnEmptyPicture) {
  EXPECT_EQ(OccupancyGrid(0.2).picture().width, 0);
  EXPECT_THROW(OccupancyGrid(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace adit::sim
