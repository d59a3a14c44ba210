#include "adit/sim/lidar.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "adit/sim/flight_fields.hpp"
#include "field_check.hpp"
#include "ray_batch.hpp"

namespace adit::sim {

using Eigen::Vector3d;

std::optional<std::string> fault_of(const LidarConfig& config) { return first_fault(config); }
std::optional<std::string> fault_of(const ImuConfig& config) { return first_fault(config); }

Lidar::Lidar(const LidarConfig& config, const RayScene& scene, std::uint64_t seed)
    : config_(config), scene_(&scene), random_(seed, 11) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

Scan Lidar::sweep(const Vector3d& place, const Eigen::Quaterniond& attitude, double stamp_s) {
  Scan scan;
  scan.stamp_s = stamp_s;
  const double fov_rad = config_.lidar_fov_deg * std::numbers::pi / 180.0;
  scan.angle_min_rad = -0.5 * fov_rad;
  scan.angle_step_rad = fov_rad / (config_.lidar_rays - 1);
  std::vector<Eigen::Vector3f> directions;
  directions.reserve(static_cast<std::size_t>(config_.lidar_rays));
  for (int i = 0; i < config_.lidar_rays; ++i) {
    const double angle = scan.angle_min_rad + i * scan.angle_step_rad;
    directions.push_back((attitude * Vector3d(std::cos(angle), std::sin(angle), 0.0)).cast<float>());
  }
  const auto range_max_m = static_cast<float>(config_.lidar_range_max_m);
  scan.ranges_m = ranges_from(*scene_, place.cast<float>(), directions, range_max_m);
  for (float& range_m : scan.ranges_m) {
    const auto noisy_m = static_cast<float>(static_cast<double>(range_m) + config_.lidar_noise_m * random_.normal());
    const bool met = range_m < range_max_m && noisy_m >= static_cast<float>(config_.lidar_range_min_m);
    range_m = met ? noisy_m : std::numeric_limits<float>::infinity();
  }
  return scan;
}

Imu::Imu(const ImuConfig& config, std::uint64_t seed) : config_(config), random_(seed, 12) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  gyro_bias_ = config_.gyro_bias_rad_s * normals();
  accelerometer_bias_ = config_.accelerometer_bias_m_s2 * normals();
}

Vector3d Imu::normals() {
  const double x = random_.normal(), y = random_.normal(), z = random_.normal();
  return {x, y, z};
}

ImuSample Imu::sample(const Vector3d& angular_rate_rad_s, const Vector3d& specific_force_m_s2, double stamp_s,
                      double interval_s) {
  const double band = 1.0 / std::sqrt(interval_s);
  ImuSample sample;
  sample.stamp_s = stamp_s;
  sample.angular_rate_rad_s = angular_rate_rad_s + gyro_bias_ + config_.gyro_noise_rad_s_rthz * band * normals();
  sample.specific_force_m_s2 =
      specific_force_m_s2 + accelerometer_bias_ + config_.accelerometer_noise_m_s2_rthz * band * normals();
  return sample;
}

}  // namespace adit::sim
