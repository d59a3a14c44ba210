// The quadrotor as its pilot sees it: a floating object that follows velocities, tilts as it must, and can be hit.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "adit/sim/random.hpp"
#include "adit/sim/scene.hpp"
#include "adit/sim/world.hpp"

namespace adit::sim {

/// Every constant of the vehicle; unit, range and source of each field stand in visit_fields() (flight_fields.hpp).
struct VehicleConfig {
  double velocity_lag_s = 0.4;
  double yaw_rate_lag_s = 0.2;
  double climb_lag_s = 0.4;
  double attitude_lag_s = 0.1;
  double tilt_max_deg = 30.0;
  double drag_1_s = 0.3;
  double body_radius_m = 0.25;

  double height_m = 1.0;
  double height_gain_1_s = 1.5;
  double climb_max_m_s = 1.0;
  double height_filter_s = 0.1;
  double height_noise_m = 0.02;
  double height_range_max_m = 20.0;

  double gust_sigma_m_s = 0.3;
  double gust_vertical_fraction = 0.5;
  double gust_time_s = 1.0;
  double yaw_rate_noise_rad_s = 0.02;
  double yaw_rate_noise_time_s = 0.5;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const VehicleConfig& config);

/// What the vehicle is told, in the frame that turns with its yaw but does not tilt.
struct VehicleCommand {
  double speed_m_s = 0.0;       ///< forward
  double yaw_rate_rad_s = 0.0;  ///< positive to the left
};

/// Where the vehicle is and how it moves. World frame unless said; angles as roll about x, pitch about y (nose down is
/// positive), yaw about z, applied in the order yaw, pitch, roll (REP 103).
struct VehicleState {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();         ///< of the body's centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< m/s
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< m/s^2, mean over the last step
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;  ///< (-pi, pi]
  double roll_rate_rad_s = 0.0;
  double pitch_rate_rad_s = 0.0;
  double yaw_rate_rad_s = 0.0;  ///< with its noise
  double height_m = 0.0;        ///< over the floor as measured and filtered

  /// Body (x forward, y left, z up) to world.
  [[nodiscard]] Eigen::Quaterniond attitude() const;
  /// Of the body frame, rad/s.
  [[nodiscard]] Eigen::Vector3d angular_rate() const;
};

/// Air that moves, and a yaw that will not stay: first-order Gauss-Markov processes, stepped exactly.
class GaussMarkov {
 public:
  GaussMarkov(double sigma, double time_s) : sigma_(sigma), time_s_(time_s) {}
  /// The value after another step. @param normal a standard normal number.
  double step(double step_s, double normal) noexcept;
  [[nodiscard]] double value() const noexcept { return value_; }

 private:
  double sigma_;
  double time_s_;
  double value_ = 0.0;
};

/// A velocity-controlled quadrotor in a world of rock. Each lag is stepped in closed form, so that the motion hardly
/// depends on the step; contact is swept, so that nothing is flown through at any speed and step.
class Vehicle {
 public:
  /// Starts at rest, height_m over the floor under `start` (or over start itself where there is no floor).
  /// @param scene must outlive the vehicle.
  /// @throws std::invalid_argument with the text of fault_of(config), or when the body would touch rock at the start.
  Vehicle(const VehicleConfig& config, const RayScene& scene, const StartPose& start, std::uint64_t seed);

  [[nodiscard]] const VehicleConfig& config() const noexcept { return config_; }
  [[nodiscard]] const VehicleState& state() const noexcept { return state_; }

  /// Flies for step_s > 0. Returns where the body touched rock: it then stays there, at rest.
  std::optional<Contact> step(const VehicleCommand& command, double step_s);

  /// What an accelerometer at the body's centre would feel, body frame, m/s^2.
  [[nodiscard]] Eigen::Vector3d specific_force() const;

 private:
  void measure_height(double step_s);
  void tilt(const Eigen::Vector3d& thrust, double step_s);

  VehicleConfig config_;
  const RayScene* scene_;
  VehicleState state_;
  double yaw_rate_true_rad_s_ = 0.0;
  GaussMarkov gust_x_, gust_y_, gust_z_, yaw_noise_;
  Random gust_random_, yaw_random_, height_random_;
};

inline constexpr double kGravity_m_s2 = 9.80665;

}  // namespace adit::sim
