#include "adit/node/watchdog.hpp"

namespace adit::node {

std::string_view to_string(Alarm alarm) noexcept {
  constexpr std::string_view kNames[] = {"none",
                                         "no image",
                                         "images are old: a slow link, clocks that disagree, or use_sim_time not set",
                                         "images are of the future: the clocks of camera and controller disagree",
                                         "the camera is frozen: it sends the same frame again and again",
                                         "no opening",
                                         "no heading"};
  return kNames[static_cast<std::size_t>(alarm)];
}

void Watchdog::advance(Time_ns now_ns) noexcept {
  if (now_ns_ && now_ns < *now_ns_) {
    // What was seen is of another time: a bag or a simulation that starts again, a clock that was set.
    ++clock_jumps_back_;
    image_ns_.reset();
    found_ns_.reset();
    heading_ns_.reset();
    arrival_ns_.reset();
    stamp_alarm_ = Alarm::kNone;
    is_frozen_ = false;
    begin_ns_ = now_ns;
  }
  now_ns_ = now_ns;
  if (!begin_ns_) begin_ns_ = now_ns;
}

bool Watchdog::is_recent(const std::optional<Time_ns>& time_ns, Time_ns now_ns) const noexcept {
  return time_ns && seconds_of(now_ns - *time_ns) < config_.hover_after_s;
}

void Watchdog::see_image(Time_ns stamp_ns, Status status, bool can_follow, Time_ns now_ns) noexcept {
  advance(now_ns);
  arrival_ns_ = now_ns;
  const double age_s = seconds_of(now_ns - stamp_ns);
  stamp_alarm_ = age_s >= config_.hover_after_s    ? Alarm::kOldImages
                 : age_s <= -config_.hover_after_s ? Alarm::kFutureImages
                                                   : Alarm::kNone;
  old_images_ += stamp_alarm_ == Alarm::kOldImages;
  future_images_ += stamp_alarm_ == Alarm::kFutureImages;
  if (stamp_alarm_ != Alarm::kNone) return;
  is_frozen_ = status == Status::kFrozenFrame;
  // A stamp a little in the future is as fresh as now, and not a moment longer.
  const Time_ns taken_ns = stamp_ns < now_ns ? stamp_ns : now_ns;
  if (!image_ns_ || taken_ns > *image_ns_) image_ns_ = taken_ns;
  if (can_follow && (!found_ns_ || taken_ns > *found_ns_)) found_ns_ = taken_ns;
}

void Watchdog::see_heading(Time_ns now_ns) noexcept {
  advance(now_ns);
  heading_ns_ = now_ns;
}

Alarm Watchdog::alarm(Time_ns now_ns) const noexcept {
  if (!is_recent(image_ns_, now_ns))
    return stamp_alarm_ != Alarm::kNone && is_recent(arrival_ns_, now_ns) ? stamp_alarm_ : Alarm::kNoImage;
  if (!is_recent(found_ns_, now_ns)) return is_frozen_ ? Alarm::kFrozen : Alarm::kNoOpening;
  if (!is_recent(heading_ns_, now_ns)) return Alarm::kNoHeading;
  return Alarm::kNone;
}

WatchdogState Watchdog::check(Time_ns now_ns) noexcept {
  advance(now_ns);
  const Alarm now = alarm(now_ns);
  if (now == Alarm::kNone) {
    begin_ns_ = *found_ns_;
    return {Watch::kFresh, now, 0.0};
  }
  if (found_ns_ && *found_ns_ > *begin_ns_) begin_ns_ = found_ns_;
  const double for_s = seconds_of(now_ns - *begin_ns_);
  return {for_s >= config_.error_after_s ? Watch::kError : Watch::kHover, now, for_s};
}

}  // namespace adit::node
