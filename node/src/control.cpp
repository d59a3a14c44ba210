#include "adit/node/control.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adit/node/settings.hpp"
#include "text.hpp"

namespace adit::node {
namespace {

const ControlConfig& checked(const ControlConfig& config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  return config;
}

}  // namespace

Control::Control(const ControlConfig& config)
    : config_(checked(config)),
      wanted_(config),
      watchdog_(config),
      image_stamps_(config.hover_after_s),
      heading_stamps_(config.hover_after_s) {}

void Control::configure(const ControlConfig& config) {
  config_ = wanted_ = checked(config);
  watchdog_.configure(config_);
}

std::vector<Parameter> Control::parameters() const { return parameters_of(wanted_); }

std::string Control::set(const std::string& name, const ParameterValue& value) {
  return set_parameter(wanted_, name, value);
}

void Control::take(const OpenSpaceNews& news, Time_ns now_ns) noexcept {
  if (!is_usable(image_stamps_.judge(news.stamp_ns))) return;  // an old image is no sign of life
  last_status_ = news.status;
  const bool can_follow = news.status == Status::kFound || (news.is_turning && config_.turn_without_opening);
  watchdog_.see_image(news.stamp_ns, news.status, can_follow, now_ns);
}

std::optional<VelocityCommand> Control::take(const HeadingNews& news, Time_ns now_ns) noexcept {
  const bool is_number = std::isfinite(news.forward_m_s) && std::isfinite(news.yaw_rate_rad_s);
  if (!is_number || !is_usable(heading_stamps_.judge(news.stamp_ns))) {
    ++refused_headings_;
    return std::nullopt;
  }
  const Time_ns age_ns = now_ns - news.stamp_ns;
  const bool is_fresh = std::abs(seconds_of(age_ns)) < config_.hover_after_s;
  if (is_fresh) watchdog_.see_heading(now_ns);
  if (watchdog_.check(now_ns).watch != Watch::kFresh || !is_fresh) {
    ++refused_headings_;
    return hover(now_ns);
  }
  latency_.add(age_ns);
  ++passed_on_;
  is_hovering_ = false;
  const double limit = config_.yaw_rate_limit_rad_s;
  return VelocityCommand{news.stamp_ns, std::clamp(news.forward_m_s, 0.0, config_.speed_max_m_s),
                         std::clamp(news.yaw_rate_rad_s, -limit, limit), false};
}

std::optional<VelocityCommand> Control::tick(Time_ns now_ns) noexcept {
  if (watchdog_.check(now_ns).watch == Watch::kFresh) return std::nullopt;
  return hover(now_ns);
}

VelocityCommand Control::hover(Time_ns now_ns) noexcept {
  if (!is_hovering_) ++hover_count_;
  is_hovering_ = true;
  return {now_ns, 0.0, 0.0, true};
}

std::string Control::alarm_text(Time_ns now_ns) {
  const WatchdogState state = watchdog_.check(now_ns);
  if (state.watch == Watch::kFresh) return "following";
  const std::string why(to_string(state.alarm));
  return state.alarm == Alarm::kNoOpening ? why + " (" + std::string(to_string(last_status_)) + ")" : why;
}

Diagnosis Control::diagnosis(Time_ns now_ns) {
  const WatchdogState state = watchdog_.check(now_ns);
  Diagnosis d;
  d.message = "following";
  if (state.watch != Watch::kFresh) {
    const std::string why = "hover for " + text_of(state.for_s, 1) + " s: " + alarm_text(now_ns);
    d.worsen(state.watch == Watch::kError ? Level::kError : Level::kWarn, why);
  }
  d.add("alarm", std::string(to_string(state.alarm)));
  d.add("status", std::string(to_string(last_status_)));
  d.add("commands", std::to_string(passed_on_));
  d.add("hovers", std::to_string(hover_count_));
  d.add("headings refused", std::to_string(refused_headings_));
  add_latency(d, "latency", latency_);
  add_stamps(d, image_stamps_);
  d.add("images of the past", std::to_string(watchdog_.old_images()));
  d.add("images of the future", std::to_string(watchdog_.future_images()));
  d.add("clock set back", std::to_string(watchdog_.clock_jumps_back()));
  return d;
}

}  // namespace adit::node
