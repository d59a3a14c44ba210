#include "adit/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

#include "share_gone.hpp"

namespace adit {
namespace {

constexpr double kBlockedAfter_s = 0.3;  // a single bad profile turns nobody round
// Ranges from brightness take black rock at the end of a drift for a gap. The frames say no_opening there for as long
// as it creeps on; in bends, even under a narrow beam, they do so for 2.5 s at the most. A trusted opening clears the
// account.
constexpr double kRefusedAfter_s = 4.0, kCreeps = 0.4;
constexpr double kRound_rad = 2.0 * std::numbers::pi + 0.5;
constexpr double kTurnDone_rad = 0.4;  // the gap that ends a turn is no further off the nose
constexpr double kSameGap_rad = 0.2;   // a gap this near to the last one is the same
constexpr double kTargetLag_s = 0.2;
constexpr double kGoalLag_s = 0.3;
constexpr double kFreeWeight = 2.0;
constexpr double kSlowFrom_rad = 0.35, kSlowTo_rad = 0.95;  // a target this far off the nose is turned to first
// Into a side passage it goes about a corner, near which the middle of the drift is the roomier way.
constexpr double kMouthGoal = 3.0;
constexpr double kSpeedLag_s = 0.2;
constexpr double kTrustLag_s = 0.5;
constexpr double kTrusted = 0.5;  // an opening that is right every other time is worth full speed: the ranges see walls
constexpr double kDoubtScale = 0.5;
constexpr double kAssumedSpeed_m_s = 1.0;  // where the caller does not say how fast it is

/// The navigator looks at rock: where there is light but no opening, it still can turn and come out.
bool is_usable(Status status) noexcept {
  return status == Status::kFound || status == Status::kNoOpening || status == Status::kNoRegion;
}

/// Whoever always takes the rightmost way and turns round at dead ends comes through every passage of a network without
/// loops.
bool keeps_right(Prefer prefer) noexcept { return prefer == Prefer::kRight || prefer == Prefer::kExplore; }

const NavigatorConfig& checked(const NavigatorConfig& config) {
  if (const auto fault = fault_of(config.steering)) throw std::invalid_argument(*fault);
  return config;
}

OpenSpace towards(double azimuth_rad) noexcept {
  OpenSpace open_space;
  open_space.status = Status::kFound;
  open_space.bearing.azimuth_rad = azimuth_rad;
  return open_space;
}

}  // namespace

Navigator::Navigator(const NavigatorConfig& config)
    : config_(checked(config)),
      finder_(config.finder),
      watch_(config.frame_watch),
      lens_watch_(config.lens_watch, config.finder.assumed_hfov_deg, config.finder.grey16_depth_bits),
      column_range_(config.column_range, config.finder.assumed_hfov_deg, config.finder.grey16_depth_bits),
      memory_(config.range_memory),
      tracker_(config.tracker),
      controller_(config.heading) {}

Navigator::Navigator(const NavigatorConfig& config, const Camera& camera)
    : config_(checked(config)),
      finder_(config.finder, camera),
      camera_(camera),
      watch_(config.frame_watch),
      lens_watch_(config.lens_watch, camera, config.finder.grey16_depth_bits),
      column_range_(config.column_range, camera, config.finder.grey16_depth_bits),
      memory_(config.range_memory),
      tracker_(config.tracker),
      controller_(config.heading) {}

void Navigator::reset() noexcept {
  memory_.reset();
  side_mouth_.reset();
  tracker_.reset();
  lens_watch_.reset();
  controller_.reset();
  last_stamp_s_.reset();
  command_ = {};
  manoeuvre_ = Manoeuvre::kWait;
  has_goal_ = false;
  goal_rad_ = target_rad_ = rival_s_ = blocked_s_ = refused_s_ = turned_rad_ = turn_sign_ = trust_ = 0.0;
}

Sight Navigator::look(const ImageView& frame) noexcept { return finish_look(frame, finder_.find(frame), true); }

Sight Navigator::look(const ImageView& frame, StageImages& images) {
  return finish_look(frame, finder_.explain(frame, images), true);
}

/// A lamp that blinks is not learnt: half of the frames do not show it.
Sight Navigator::look_flash(const ImageView& frame, const ImageView& before) noexcept {
  return finish_look(frame, finder_.find_flash(frame, before), false);
}

void Navigator::use_lamp(const LampPattern& known, bool learn) {
  if (*fault_of(known) != '\0') throw std::invalid_argument(fault_of(known));
  known_lamp_ = known;
  learns_lamp_ = learn;
  lamp_.reset();
  finder_.set_lamp(known);
}

void Navigator::learn_lamp(const ImageView& frame) noexcept {
  const LampGlimpse glimpse = finder_.lamp_glimpse();
  if (!glimpse.usable) return;
  try {
    if (!lamp_) {
      const double hfov_deg = config_.finder.assumed_hfov_deg;
      lamp_.emplace(camera_ ? *camera_ : Camera(pinhole(frame.width, frame.height, hfov_deg)), known_lamp_);
    }
  } catch (const std::exception&) {  // no memory for it: the flight goes on without
    learns_lamp_ = false;
    return;
  }
  if (lamp_->learn(glimpse)) finder_.set_lamp(lamp_->pattern());
}

Sight Navigator::finish_look(const ImageView& frame, const OpenSpace& open_space, bool learn) noexcept {
  Sight sight;
  sight.open_space = open_space;
  if (learn && learns_lamp_ && is_usable(open_space.status)) learn_lamp(frame);
  sight.profile = column_range_.measure(frame, memory_.veil_share());
  const Status stream = watch_.judge(frame);
  // What the frame alone shows to be wrong is the better name for it: a dead lamp's black frames are also all the same.
  if (stream != Status::kFound && is_usable(sight.open_space.status)) sight.open_space.status = stream;
  if (config_.finder.method == Method::kAdit && is_usable(sight.open_space.status)) watch_lens(frame, sight);
  return sight;
}

void Navigator::watch_lens(const ImageView& frame, Sight& sight) noexcept {
  lens_watch_.look(frame);
  lens_watch_.take_out(sight.open_space);
  constexpr double kDegree = std::numbers::pi / 180.0;
  lens_watch_.take_out(sight.profile, kDegree * config_.column_range.band_low_deg,
                       kDegree * config_.column_range.band_high_deg);
}

Step Navigator::step_to(double stamp_s, const Motion& motion) noexcept {
  Step step;
  if (last_stamp_s_) step.time_s = std::clamp(stamp_s - *last_stamp_s_, 0.0, config_.heading.hold_after_s);
  last_stamp_s_ = stamp_s;
  step.yaw_rad = step.time_s * motion.yaw_rate_rad_s.value_or(command_.heading.yaw_rate_rad_s);
  step.forward_m = step.time_s * motion.speed_m_s.value_or(kAssumedSpeed_m_s * command_.speed_scale);
  return step;
}

StampFault Navigator::fault_of_stamp(double stamp_s) const noexcept {
  if (!std::isfinite(stamp_s)) return StampFault::kNotLater;
  if (!last_stamp_s_) return StampFault::kNone;
  const double later_s = stamp_s - *last_stamp_s_, hold_s = config_.heading.hold_after_s;
  if (later_s > hold_s) return StampFault::kJump;
  if (later_s > 0.0) return StampFault::kNone;
  return later_s < -hold_s ? StampFault::kBackwards : StampFault::kNotLater;
}

NavigatorCommand Navigator::steer(const Sight& sight, double stamp_s, const Motion& motion) noexcept {
  const StampFault stamp_fault = fault_of_stamp(stamp_s);
  if (stamp_fault == StampFault::kBackwards) reset();
  command_.stamp_fault = stamp_fault;
  command_.status = sight.open_space.status;
  if (stamp_fault == StampFault::kNotLater) return hold(stamp_s);
  if (stamp_fault == StampFault::kJump) memory_.reset();  // nobody knows where the walls are now
  const Step step = step_to(stamp_s, motion);
  memory_.move(step);
  lens_watch_.turn(step.yaw_rad);
  tracker_.update(sight.open_space, step.time_s, step.yaw_rad);
  goal_rad_ += step.yaw_rad;
  target_rad_ += step.yaw_rad;
  turned_rad_ += step.yaw_rad;
  if (!is_usable(sight.open_space.status) || !sight.profile.valid) return hold(stamp_s);
  memory_.take(sight.profile, step.time_s);
  ways_ = ways_of(config_.steering, memory_.profile(), memory_.beside());
  trust_ += share_gone(step.time_s, kTrustLag_s) * (sight.open_space.confidence - trust_);
  choose_gap(step);
  if (manoeuvre_ == Manoeuvre::kWait) manoeuvre_ = Manoeuvre::kFollow;
  blocked_s_ = has_goal_ ? 0.0 : blocked_s_ + step.time_s;
  count_refusals(sight.open_space, step.time_s);
  const bool is_blocked = blocked_s_ >= kBlockedAfter_s || refused_s_ >= kRefusedAfter_s;
  if (manoeuvre_ == Manoeuvre::kFollow && is_blocked) begin_turn();
  command_ = manoeuvre_ == Manoeuvre::kFollow ? follow(stamp_s, step.time_s) : turn(stamp_s);
  command_.status = sight.open_space.status;
  command_.stamp_fault = stamp_fault;
  command_.manoeuvre = manoeuvre_;
  return command_;
}

/// For how long it has crept on although the frames show no way on.
void Navigator::count_refusals(const OpenSpace& open_space, double time_s) noexcept {
  if (open_space.found() && open_space.confidence >= kTrusted) refused_s_ = 0.0;
  if (open_space.status == Status::kNoOpening && command_.speed_scale < kCreeps) refused_s_ += time_s;
}

/// A frame that says nothing about the way.
NavigatorCommand Navigator::hold(double stamp_s) noexcept {
  command_.heading = controller_.update(OpenSpace{}, stamp_s);
  return held();
}

NavigatorCommand Navigator::tick(double now_s) noexcept {
  command_.heading = controller_.tick(now_s);
  command_.stamp_fault = StampFault::kNone;
  return held();
}

NavigatorCommand Navigator::held() noexcept {
  if (command_.heading.state == HeadingState::kHold) {
    command_.speed_scale = 0.0;
    command_.manoeuvre = Manoeuvre::kWait;
  }
  return command_;
}

/// Whoever prefers a side takes every passage that leaves to it.
std::optional<double> Navigator::side_mouth(const Step& step) noexcept {
  const Prefer prefer = config_.steering.prefer;
  if (prefer == Prefer::kStraight || manoeuvre_ != Manoeuvre::kFollow) {
    side_mouth_.reset();
    return std::nullopt;
  }
  return side_mouth_.update(memory_.profile(), keeps_right(prefer) ? 1.0 : -1.0, step);
}

void Navigator::choose_gap(const Step& step) noexcept {
  const std::optional<double> mouth = side_mouth(step);
  std::array<Gap, kGapsMax> gaps;
  const std::size_t count = gaps_of(config_.steering, memory_.profile(), ways_, gaps);
  const auto worth = [this](const Gap& gap) {
    double w = gap.free_m * (1.0 - 0.3 * std::abs(gap.azimuth_rad));
    if (config_.steering.prefer == Prefer::kLeft) w -= 4.0 * gap.azimuth_rad;
    if (keeps_right(config_.steering.prefer)) w += 4.0 * gap.azimuth_rad;
    if (const Track* track = tracker_.chosen(); track != nullptr && track->unseen_s <= 0.0)
      if (std::abs(track->bearing.azimuth_rad - gap.azimuth_rad) <= gap.half_width_rad + 0.1)
        w *= 1.0 + 0.3 * track->score;
    return w;
  };
  const Gap* best = nullptr;
  const Gap* same = nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    if (best == nullptr || worth(gaps[i]) > worth(*best)) best = &gaps[i];
    const double off = std::abs(gaps[i].azimuth_rad - goal_rad_) - gaps[i].half_width_rad;
    if (has_goal_ && off <= kSameGap_rad &&
        (same == nullptr || std::abs(gaps[i].azimuth_rad - goal_rad_) < std::abs(same->azimuth_rad - goal_rad_)))
      same = &gaps[i];
  }
  if (best == nullptr) {
    has_goal_ = false;
    return;
  }
  if (mouth) {
    goal_rad_ = *mouth;
    has_goal_ = true;
    rival_s_ = 0.0;
    return;
  }
  if (same == nullptr) {
    goal_rad_ = best->azimuth_rad;
    has_goal_ = true;
    rival_s_ = 0.0;
    return;
  }
  rival_s_ = best != same && worth(*best) > 1.3 * worth(*same) ? rival_s_ + step.time_s : 0.0;
  if (rival_s_ >= config_.tracker.switch_after_s) {
    goal_rad_ = best->azimuth_rad;
    rival_s_ = 0.0;
    return;
  }
  goal_rad_ += share_gone(step.time_s, kGoalLag_s) * (same->azimuth_rad - goal_rad_);
}

double Navigator::choose_target() const noexcept {
  const SteeringConfig& c = config_.steering;
  const RangeProfile& profile = memory_.profile();
  const double goal_weight = c.goal_weight * (side_mouth_.taking() ? kMouthGoal : 1.0);
  std::array<double, kRangeBins> cost;
  std::size_t best = 0;
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    const double azimuth = profile.azimuth_rad(static_cast<int>(bin));
    const double lack = std::max(1.0 - static_cast<double>(ways_.free_m[bin]) / c.look_ahead_m, 0.0);
    const double off = azimuth - goal_rad_, change = azimuth - target_rad_;
    cost[bin] = c.clearance_weight * static_cast<double>(ways_.crowd[bin]) + goal_weight * off * off +
                c.change_weight * change * change + kFreeWeight * lack * lack;
    if (cost[bin] < cost[best]) best = bin;
  }
  return profile.azimuth_rad(static_cast<int>(best));
}

double Navigator::free_ahead_m() const noexcept {
  const RangeProfile& profile = memory_.profile();
  const double bin = -profile.azimuth_first_rad / profile.azimuth_step_rad;
  const auto at = static_cast<std::size_t>(std::clamp(bin, 1.0, kRangeBins - 2.0));
  return static_cast<double>(std::max({ways_.free_m[at - 1], ways_.free_m[at], ways_.free_m[at + 1]}));
}

double Navigator::speed_scale() const noexcept {
  const SteeringConfig& c = config_.steering;
  const double near = std::clamp((free_ahead_m() - c.stop_range_m) / (c.slow_range_m - c.stop_range_m), 0.0, 1.0);
  const double turning =
      std::clamp(1.0 - (std::abs(target_rad_) - kSlowFrom_rad) / (kSlowTo_rad - kSlowFrom_rad), 0.25, 1.0);
  return near * turning * std::clamp(trust_ / kTrusted, kDoubtScale, 1.0);
}

NavigatorCommand Navigator::follow(double stamp_s, double time_s) noexcept {
  NavigatorCommand command;
  if (has_goal_) target_rad_ += share_gone(time_s, kTargetLag_s) * (choose_target() - target_rad_);
  command.heading = controller_.update(towards(target_rad_), stamp_s);
  const double wanted = has_goal_ ? speed_scale() : 0.0;
  // Slows at once, and gets faster slowly.
  command.speed_scale =
      std::min(wanted, command_.speed_scale + share_gone(time_s, kSpeedLag_s) * (wanted - command_.speed_scale) + 0.02);
  command.target_rad = target_rad_;
  command.goal_rad = goal_rad_;
  command.free_m = free_ahead_m();
  return command;
}

void Navigator::begin_turn() noexcept {
  manoeuvre_ = Manoeuvre::kTurn;
  turned_rad_ = refused_s_ = 0.0;
  double left = 0.0, right = 0.0;
  for (std::size_t bin = 0; bin < kRangeBins; ++bin)
    (bin < kRangeBins / 2 ? left : right) += static_cast<double>(ways_.free_m[bin] + memory_.profile().range_m[bin]);
  turn_sign_ = left >= right ? 1.0 : -1.0;
  if (config_.steering.prefer == Prefer::kLeft && left > 0.7 * right) turn_sign_ = 1.0;
  if (keeps_right(config_.steering.prefer) && right > 0.7 * left) turn_sign_ = -1.0;
}

NavigatorCommand Navigator::turn(double stamp_s) noexcept {
  const SteeringConfig& c = config_.steering;
  NavigatorCommand command;
  command.free_m = free_ahead_m();
  command.goal_rad = goal_rad_;
  double longest = 0.0;
  for (const float free_m : ways_.free_m) longest = std::max(longest, static_cast<double>(free_m));
  if (has_goal_ && longest >= c.clear_range_m && std::abs(goal_rad_) <= kTurnDone_rad &&
      (std::abs(turned_rad_) >= c.turn_min_rad || manoeuvre_ == Manoeuvre::kGiveUp)) {
    manoeuvre_ = Manoeuvre::kFollow;
    blocked_s_ = 0.0;
    target_rad_ = goal_rad_;
    command.target_rad = target_rad_;
    command.heading = controller_.update(towards(target_rad_), stamp_s);
    return command;
  }
  if (std::abs(turned_rad_) > kRound_rad) manoeuvre_ = Manoeuvre::kGiveUp;
  if (manoeuvre_ == Manoeuvre::kGiveUp) {
    command.heading = controller_.update(OpenSpace{}, stamp_s);
    return command;
  }
  // The rate of a turn, through the controller with its limits.
  const double azimuth_rad =
      -turn_sign_ * (c.turn_rate_rad_s / std::max(config_.heading.gain_per_s, 1e-6) + config_.heading.dead_band_rad);
  command.target_rad = target_rad_ = 0.0;
  command.heading = controller_.update(towards(azimuth_rad), stamp_s);
  return command;
}

}  // namespace adit
