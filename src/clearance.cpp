#include "adit/clearance.hpp"

#include <algorithm>
#include <cmath>

namespace adit {
namespace {

constexpr float kOpenShare = 0.65f;  // of the longest free way: directions that go as far belong to a gap

struct Direction {
  float forward = 1.0f, right = 0.0f;
};

/// Distance from a point to the straight way of this length, and where along the way that is.
struct Foot {
  float along_m = 0.0f;
  float aside_m = 0.0f;  ///< positive to the right of the way
};

Foot foot_of(const Direction& way, float forward_m, float right_m) noexcept {
  return {forward_m * way.forward + right_m * way.right, right_m * way.forward - forward_m * way.right};
}

/// Takes walls one by one and keeps what they leave of a way.
class WayTaken {
 public:
  WayTaken(const SteeringConfig& config, const Direction& way, float free_m) noexcept
      : way_(way),
        half_m_(static_cast<float>(config.body_half_width_m + config.margin_m)),
        clearance_m_(static_cast<float>(config.clearance_m)),
        look_ahead_m_(static_cast<float>(config.look_ahead_m)),
        free_m_(free_m) {}

  void add(float forward_m, float right_m) noexcept {
    const Foot foot = foot_of(way_, forward_m, right_m);
    const float aside = std::abs(foot.aside_m);
    if (foot.along_m > 0.0f && aside < half_m_)
      free_m_ = std::min(free_m_, std::max(foot.along_m - std::sqrt(half_m_ * half_m_ - aside * aside), 0.0f));
    const float beyond = foot.along_m - std::clamp(foot.along_m, 0.0f, look_ahead_m_);
    const float distance = std::sqrt(beyond * beyond + aside * aside);
    const float lack = std::max(1.0f - distance / clearance_m_, 0.0f);
    (foot.aside_m > 0.0f ? right_ : left_) += lack * lack;
    nearest_lack_ = std::max(nearest_lack_, lack);
  }

  [[nodiscard]] float free_m() const noexcept { return free_m_; }
  [[nodiscard]] float crowd() const noexcept { return nearest_lack_ * nearest_lack_; }

 private:
  Direction way_;
  float half_m_, clearance_m_, look_ahead_m_;
  float free_m_;
  float left_ = 0.0f, right_ = 0.0f, nearest_lack_ = 0.0f;
};

}  // namespace

Ways ways_of(const SteeringConfig& config, const RangeProfile& profile, std::span<const WallPoint> beside) noexcept {
  std::array<Direction, kRangeBins> directions;
  std::array<WallPoint, kRangeBins> seen;
  float longest = 0.0f;
  for (const float range_m : profile.range_m) longest = std::max(longest, range_m);
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    const double azimuth = profile.azimuth_rad(static_cast<int>(bin));
    directions[bin] = {static_cast<float>(std::cos(azimuth)), static_cast<float>(std::sin(azimuth))};
    seen[bin] = {profile.range_m[bin] * directions[bin].forward, profile.range_m[bin] * directions[bin].right, 0.0f};
  }
  Ways ways;
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    WayTaken taken(config, directions[bin], longest);
    for (const WallPoint& p : seen) taken.add(p.forward_m, p.right_m);
    for (const WallPoint& p : beside) taken.add(p.forward_m, p.right_m);
    ways.free_m[bin] = taken.free_m();
    ways.crowd[bin] = taken.crowd();
  }
  return ways;
}

std::size_t gaps_of(const SteeringConfig& config, const RangeProfile& profile, const Ways& ways,
                    std::span<Gap> gaps) noexcept {
  float longest = 0.0f;
  for (const float free_m : ways.free_m) longest = std::max(longest, free_m);
  const float open_m = std::max(kOpenShare * longest, static_cast<float>(config.stop_range_m));
  std::size_t count = 0;
  for (std::size_t bin = 0; bin < kRangeBins && count < gaps.size();) {
    if (ways.free_m[bin] < open_m) {
      ++bin;
      continue;
    }
    const std::size_t first = bin;
    double weight = 0.0, sum = 0.0;
    float best = 0.0f;
    for (; bin < kRangeBins && ways.free_m[bin] >= open_m; ++bin) {
      const double w = static_cast<double>(ways.free_m[bin]) * static_cast<double>(ways.free_m[bin]);
      weight += w;
      sum += w * profile.azimuth_rad(static_cast<int>(bin));
      best = std::max(best, ways.free_m[bin]);
    }
    gaps[count++] = {sum / weight, static_cast<double>(best),
                     0.5 * profile.azimuth_step_rad * static_cast<double>(bin - first)};
  }
  return count;
}

}  // namespace adit
