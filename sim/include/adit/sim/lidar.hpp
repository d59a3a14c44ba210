// A scanning laser in the body's plane, and an inertial unit: what the map is drawn from, and for later use.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/sim/random.hpp"
#include "adit/sim/scene.hpp"

namespace adit::sim {

/// Unit, range and source of each field stand in visit_fields() (flight_fields.hpp).
struct LidarConfig {
  double lidar_rate_hz = 10.0;
  double lidar_fov_deg = 270.0;
  int lidar_rays = 541;
  double lidar_range_min_m = 0.1;
  double lidar_range_max_m = 30.0;
  double lidar_noise_m = 0.02;
};

[[nodiscard]] std::optional<std::string> fault_of(const LidarConfig& config);

/// One sweep, from right to left.
struct Scan {
  double stamp_s = 0.0;
  double angle_min_rad = 0.0;  ///< of the first ray to the body's x axis, positive to the left
  double angle_step_rad = 0.0;
  std::vector<float> ranges_m;  ///< infinity where nothing is within range
};

/// Sees with the body's tilt. The sweep is taken as instantaneous: at 1 m/s the body moves 25 mm in a sweep.
class Lidar {
 public:
  /// @throws std::invalid_argument with fault_of(config).
  Lidar(const LidarConfig& config, const RayScene& scene, std::uint64_t seed);

  [[nodiscard]] const LidarConfig& config() const noexcept { return config_; }
  [[nodiscard]] Scan sweep(const Eigen::Vector3d& place, const Eigen::Quaterniond& attitude, double stamp_s);

 private:
  LidarConfig config_;
  const RayScene* scene_;
  Random random_;
};

/// Unit, range and source of each field stand in visit_fields() (flight_fields.hpp).
struct ImuConfig {
  double gyro_noise_rad_s_rthz = 8.7e-5;
  double gyro_bias_rad_s = 0.002;
  double accelerometer_noise_m_s2_rthz = 0.0039;
  double accelerometer_bias_m_s2 = 0.02;
};

[[nodiscard]] std::optional<std::string> fault_of(const ImuConfig& config);

/// Body frame.
struct ImuSample {
  double stamp_s = 0.0;
  Eigen::Vector3d angular_rate_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_m_s2 = Eigen::Vector3d::Zero();
};

/// White noise and a bias that is drawn once a flight.
class Imu {
 public:
  /// @throws std::invalid_argument with fault_of(config).
  Imu(const ImuConfig& config, std::uint64_t seed);

  /// @param interval_s  since the last sample, > 0: the noise of a reading grows with the bandwidth.
  [[nodiscard]] ImuSample sample(const Eigen::Vector3d& angular_rate_rad_s, const Eigen::Vector3d& specific_force_m_s2,
                                 double stamp_s, double interval_s);

 private:
  Eigen::Vector3d normals();

  ImuConfig config_;
  Random random_;
  Eigen::Vector3d gyro_bias_, accelerometer_bias_;
};

}  // namespace adit::sim
