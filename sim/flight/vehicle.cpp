#include "adit/sim/vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "adit/sim/flight_fields.hpp"
#include "field_check.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;

constexpr double kStartLift_m = 0.5;  // the floor is looked for from here, so that a start on the floor is not under it

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

/// Share of the way to its goal that a first-order lag goes in a step.
double share_gone(double step_s, double lag_s) { return lag_s > 0.0 ? -std::expm1(-step_s / lag_s) : 1.0; }

/// A value that follows `wanted` with a lag, and the way it goes meanwhile, both exact for a constant `wanted`.
double follow(double& value, double wanted, double step_s, double lag_s) {
  const double share = share_gone(step_s, lag_s);
  const double way = wanted * step_s + (value - wanted) * lag_s * share;
  value += (wanted - value) * share;
  return way;
}

std::optional<float> floor_below(const RayScene& scene, const Vector3d& place, double range_max_m) {
  const auto hit = scene.closest_hit(place.cast<float>(), -Eigen::Vector3f::UnitZ(), static_cast<float>(range_max_m));
  return hit ? std::optional(hit->range_m) : std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of(const VehicleConfig& config) { return first_fault(config); }

Eigen::Quaterniond VehicleState::attitude() const {
  return Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch_rad, Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll_rad, Vector3d::UnitX());
}

Vector3d VehicleState::angular_rate() const {
  const double sr = std::sin(roll_rad), cr = std::cos(roll_rad), sp = std::sin(pitch_rad), cp = std::cos(pitch_rad);
  return {roll_rate_rad_s - yaw_rate_rad_s * sp, pitch_rate_rad_s * cr + yaw_rate_rad_s * sr * cp,
          -pitch_rate_rad_s * sr + yaw_rate_rad_s * cr * cp};
}

double GaussMarkov::step(double step_s, double normal) noexcept {
  const double kept = std::exp(-step_s / time_s_);
  value_ = kept * value_ + sigma_ * std::sqrt(1.0 - kept * kept) * normal;
  return value_;
}

Vehicle::Vehicle(const VehicleConfig& config, const RayScene& scene, const StartPose& start, std::uint64_t seed)
    : config_(config),
      scene_(&scene),
      gust_x_(config.gust_sigma_m_s, config.gust_time_s),
      gust_y_(config.gust_sigma_m_s, config.gust_time_s),
      gust_z_(config.gust_sigma_m_s * config.gust_vertical_fraction, config.gust_time_s),
      yaw_noise_(config.yaw_rate_noise_rad_s, config.yaw_rate_noise_time_s),
      gust_random_(seed, 1),
      yaw_random_(seed, 2),
      height_random_(seed, 3) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  state_.place = start.place.cast<double>() + kStartLift_m * Vector3d::UnitZ();
  const auto floor = floor_below(scene, state_.place, config.height_range_max_m);
  state_.place.z() += config.height_m - (floor ? static_cast<double>(*floor) : kStartLift_m);
  state_.height_m = config.height_m;
  state_.yaw_rad = wrapped(start.yaw_rad);
  const auto near = scene.nearest(state_.place.cast<float>(), static_cast<float>(config.body_radius_m));
  if (near)
    throw std::invalid_argument("the start (" + shown(state_.place.x()) + ", " + shown(state_.place.y()) + ", " +
                                shown(state_.place.z()) + ") is " + shown(static_cast<double>(near->distance_m)) +
                                " m from rock, less than body_radius_m " + shown(config.body_radius_m) +
                                ": start further away from it");
}

void Vehicle::measure_height(double step_s) {
  const double noise_m = config_.height_noise_m * height_random_.normal();
  const auto floor = floor_below(*scene_, state_.place, config_.height_range_max_m);
  if (!floor) return;  // over a hole: the last height stands
  const double measured_m = std::max(0.0, static_cast<double>(*floor) + noise_m);
  state_.height_m += (measured_m - state_.height_m) * share_gone(step_s, config_.height_filter_s);
}

void Vehicle::tilt(const Vector3d& thrust, double step_s) {
  const double limit_rad = config_.tilt_max_deg * std::numbers::pi / 180.0;
  const double pitch_rad = std::clamp(std::atan2(thrust.x(), thrust.z()), -limit_rad, limit_rad);
  const double roll_rad =
      std::clamp(std::atan2(-thrust.y(), std::hypot(thrust.x(), thrust.z())), -limit_rad, limit_rad);
  const double pitch_before = state_.pitch_rad, roll_before = state_.roll_rad;
  follow(state_.pitch_rad, pitch_rad, step_s, config_.attitude_lag_s);
  follow(state_.roll_rad, roll_rad, step_s, config_.attitude_lag_s);
  state_.pitch_rate_rad_s = (state_.pitch_rad - pitch_before) / step_s;
  state_.roll_rate_rad_s = (state_.roll_rad - roll_before) / step_s;
}

std::optional<Contact> Vehicle::step(const VehicleCommand& command, double step_s) {
  measure_height(step_s);
  const Vector3d gust(gust_x_.step(step_s, gust_random_.normal()), gust_y_.step(step_s, gust_random_.normal()),
                      gust_z_.step(step_s, gust_random_.normal()));
  const double yaw_noise = yaw_noise_.step(step_s, yaw_random_.normal());

  const double turn = follow(yaw_rate_true_rad_s_, command.yaw_rate_rad_s, step_s, config_.yaw_rate_lag_s);
  state_.yaw_rate_rad_s = yaw_rate_true_rad_s_ + yaw_noise;
  const double yaw_middle = state_.yaw_rad + 0.5 * turn;
  state_.yaw_rad = wrapped(state_.yaw_rad + turn + yaw_noise * step_s);

  const double climb = std::clamp(config_.height_gain_1_s * (config_.height_m - state_.height_m),
                                  -config_.climb_max_m_s, config_.climb_max_m_s);
  // The pilot holds the air speed it knows; a gust pushes by its drag and is fought by the lag alone.
  const Vector3d pushed = config_.drag_1_s * gust.cwiseProduct(Vector3d(config_.velocity_lag_s, config_.velocity_lag_s,
                                                                        config_.climb_lag_s));
  const Vector3d wanted =
      Vector3d(command.speed_m_s * std::cos(yaw_middle), command.speed_m_s * std::sin(yaw_middle), climb) + pushed;
  const Vector3d before = state_.velocity;
  const Vector3d way(follow(state_.velocity.x(), wanted.x(), step_s, config_.velocity_lag_s),
                     follow(state_.velocity.y(), wanted.y(), step_s, config_.velocity_lag_s),
                     follow(state_.velocity.z(), wanted.z(), step_s, config_.climb_lag_s));
  state_.acceleration = (state_.velocity - before) / step_s;
  const Vector3d thrust =
      state_.acceleration + config_.drag_1_s * (state_.velocity - gust) + kGravity_m_s2 * Vector3d::UnitZ();
  tilt(Eigen::AngleAxisd(-state_.yaw_rad, Vector3d::UnitZ()) * thrust, step_s);

  const Eigen::Vector3f start = state_.place.cast<float>();
  const Eigen::Vector3f end = (state_.place + way).cast<float>();
  const auto contact = scene_->first_contact(start, end, static_cast<float>(config_.body_radius_m));
  if (!contact) {
    state_.place += way;
    return std::nullopt;
  }
  state_.place = contact->centre.cast<double>();
  state_.velocity.setZero();
  return contact;
}

Vector3d Vehicle::specific_force() const {
  return state_.attitude().conjugate() * (state_.acceleration + kGravity_m_s2 * Vector3d::UnitZ());
}

}  // namespace adit::sim
