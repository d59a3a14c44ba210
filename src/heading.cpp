#include "adit/heading.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace adit {
namespace {

constexpr double kStaleStepMin =
    0.02;  // of hold_after_s: a frozen stream of frames holds after 50 frames at the latest

/// The dead band is taken off, so that the command grows from zero at its edge instead of jumping.
double beyond_dead_band(double azimuth_rad, double dead_band_rad) noexcept {
  return std::copysign(std::max(std::abs(azimuth_rad) - dead_band_rad, 0.0), azimuth_rad);
}

}  // namespace

HeadingController::HeadingController(const HeadingConfig& config) : config_(config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

void HeadingController::reset() noexcept {
  last_stamp_s_.reset();
  last_time_s_.reset();
  last_found_s_.reset();
  interval_s_ = 0.0;
  stale_s_ = 0.0;
  yaw_rate_rad_s_ = 0.0;
}

HeadingCommand HeadingController::update(const OpenSpace& open_space, double stamp_s) noexcept {
  if (!std::isfinite(stamp_s)) return stale();
  if (last_stamp_s_ && stamp_s <= *last_stamp_s_) {
    if (*last_stamp_s_ - stamp_s <= config_.hold_after_s) return stale();
    reset();
  }
  const double elapsed_s = advance_to(stamp_s);
  last_stamp_s_ = stamp_s;
  if (!open_space.found() || !std::isfinite(open_space.bearing.azimuth_rad)) {
    return elapsed_s > 0.0 ? coast_or_hold(elapsed_s) : stale();  // from before the last tick: no news
  }
  last_found_s_ = stamp_s;
  const double off_rad = beyond_dead_band(open_space.bearing.azimuth_rad, config_.dead_band_rad);
  const double wanted_rad_s =
      std::clamp(config_.gain_per_s * yaw_of_azimuth(off_rad), -config_.yaw_rate_max_rad_s, config_.yaw_rate_max_rad_s);
  yaw_rate_rad_s_ = limited(wanted_rad_s, elapsed_s);
  return {HeadingState::kSteer, yaw_rate_rad_s_};
}

HeadingCommand HeadingController::tick(double now_s) noexcept {
  if (!std::isfinite(now_s)) return stale();
  if (last_time_s_ && now_s <= *last_time_s_) {
    if (*last_time_s_ - now_s <= config_.hold_after_s) return stale();
    reset();
  }
  return coast_or_hold(advance_to(now_s));
}

HeadingCommand HeadingController::stale() noexcept {
  // Not nothing, even after two frames that were hardly apart: a stale command must run down.
  const double step_s = std::max(interval_s_, kStaleStepMin * config_.hold_after_s);
  stale_s_ += step_s;
  return coast_or_hold(step_s);
}

double HeadingController::advance_to(double time_s) noexcept {
  stale_s_ = 0.0;
  const double elapsed_s = last_time_s_ ? std::max(time_s - *last_time_s_, 0.0) : 0.0;
  last_time_s_ = last_time_s_ ? std::max(time_s, *last_time_s_) : time_s;
  if (elapsed_s >= config_.hold_after_s) {
    // The command had to be to hold by now, asked for or not: steering starts again from zero.
    yaw_rate_rad_s_ = 0.0;
    return 0.0;
  }
  if (elapsed_s > 0.0) interval_s_ = elapsed_s;
  return elapsed_s;
}

HeadingCommand HeadingController::coast_or_hold(double elapsed_s) noexcept {
  const bool hold = !last_found_s_ || *last_time_s_ + stale_s_ - *last_found_s_ >= config_.hold_after_s;
  yaw_rate_rad_s_ = hold ? 0.0 : limited(0.0, elapsed_s);
  return {hold ? HeadingState::kHold : HeadingState::kCoast, yaw_rate_rad_s_};
}

double HeadingController::limited(double wanted_rad_s, double elapsed_s) const noexcept {
  const double change_rad_s = config_.yaw_acceleration_max_rad_s2 * elapsed_s;
  return std::clamp(wanted_rad_s, yaw_rate_rad_s_ - change_rad_s, yaw_rate_rad_s_ + change_rad_s);
}

}  // namespace adit
