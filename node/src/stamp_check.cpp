#include "adit/node/stamp_check.hpp"

#include <algorithm>
#include <cmath>

namespace adit::node {
namespace {

constexpr std::size_t kIntervalsToJudge = 3;
// An interval this much longer than usual holds one frame less than it should: jitter stays below half a period.
constexpr double kLostFrom = 1.5;

}  // namespace

std::string_view to_string(StampVerdict verdict) noexcept {
  constexpr std::string_view kNames[] = {"fresh", "missing", "duplicate", "reordered", "restarted", "gap"};
  return kNames[static_cast<std::size_t>(verdict)];
}

double StampCheck::interval_s() const noexcept {
  const std::size_t count = std::min(interval_count_, kIntervals);
  if (count < kIntervalsToJudge) return 0.0;
  auto sorted = intervals_ns_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return seconds_of(*middle);
}

void StampCheck::take_interval(Time_ns interval_ns) noexcept {
  const double usual_s = interval_s();
  if (usual_s > 0.0 && seconds_of(interval_ns) > kLostFrom * usual_s)
    lost_ += std::llround(seconds_of(interval_ns) / usual_s) - 1;
  intervals_ns_[interval_count_++ % kIntervals] = interval_ns;
}

StampVerdict StampCheck::judged(Time_ns stamp_ns) const noexcept {
  if (stamp_ns == 0) return StampVerdict::kMissing;
  if (!last_ns_) return StampVerdict::kFresh;
  const Time_ns later_ns = stamp_ns - *last_ns_;
  if (later_ns == 0) return StampVerdict::kDuplicate;
  if (later_ns > jump_after_ns_) return StampVerdict::kGap;
  if (later_ns > 0) return StampVerdict::kFresh;
  return later_ns < -jump_after_ns_ ? StampVerdict::kRestarted : StampVerdict::kReordered;
}

StampVerdict StampCheck::judge(Time_ns stamp_ns) noexcept {
  const StampVerdict verdict = judged(stamp_ns);
  ++counts_[static_cast<std::size_t>(verdict)];
  if (verdict == StampVerdict::kFresh && last_ns_) take_interval(stamp_ns - *last_ns_);
  if (verdict != StampVerdict::kMissing && is_usable(verdict)) last_ns_ = stamp_ns;
  return verdict;
}

void StampCheck::reset() noexcept {
  const Time_ns jump_after_ns = jump_after_ns_;
  *this = StampCheck();
  jump_after_ns_ = jump_after_ns;
}

}  // namespace adit::node
