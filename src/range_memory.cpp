#include "adit/range_memory.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "share_gone.hpp"

namespace adit {
namespace {

constexpr double kVeilFall_s = 0.5;
// Edges are kept when the vehicle has gone this far or turned this much: closer points would say the same again.
constexpr double kKeepEach_m = 0.2;
constexpr double kKeepEach_rad = 0.06;
constexpr double kBehind_m = 2.0;    // further behind, a wall is no longer in any way
constexpr float kSeenShare = 0.8f;   // of range_max: further away it is the end of sight, not rock
constexpr std::size_t kEdgeBin = 1;  // the outermost bin may be cut by the lens's edge

}  // namespace

RangeMemory::RangeMemory(const RangeMemoryConfig& config) : config_(config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

void RangeMemory::reset() noexcept {
  profile_ = {};
  veil_share_ = 0.0;
  veil_known_ = false;
  moved_ = 0.0;
  beside_count_ = 0;
}

void RangeMemory::move(const Step& step) noexcept {
  moved_ += std::abs(step.forward_m) / kKeepEach_m + std::abs(step.yaw_rad) / kKeepEach_rad;
  if (profile_.valid && step.yaw_rad != 0.0) turn_profile(step.yaw_rad);
  const float c = static_cast<float>(std::cos(step.yaw_rad)), s = static_cast<float>(std::sin(step.yaw_rad));
  const auto forward = static_cast<float>(step.forward_m), age = static_cast<float>(step.time_s);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < beside_count_; ++i) {
    WallPoint p = beside_[i];
    const float ahead = p.forward_m - forward;
    // A turn to the left takes what lies ahead to the right.
    p = {c * ahead - s * p.right_m, s * ahead + c * p.right_m, p.age_s + age};
    if (p.age_s <= static_cast<float>(config_.keep_s) && p.forward_m > -static_cast<float>(kBehind_m))
      beside_[kept++] = p;
  }
  beside_count_ = kept;
}

void RangeMemory::turn_profile(double yaw_rad) noexcept {
  const std::array<float, kRangeBins> before = profile_.range_m;
  const double shift = yaw_rad / profile_.azimuth_step_rad;
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    const double at = std::clamp(static_cast<double>(bin) - shift, 0.0, kRangeBins - 1.0);
    const auto low = std::min(static_cast<std::size_t>(at), std::size_t{kRangeBins - 2});
    const auto share = static_cast<float>(at - static_cast<double>(low));
    profile_.range_m[bin] = before[low] + share * (before[low + 1] - before[low]);
  }
}

void RangeMemory::take(const RangeProfile& profile, double time_s) noexcept {
  if (!profile.valid) return;
  const double wanted = profile.veil_share;
  veil_share_ += (wanted - veil_share_) *
                 (veil_known_ ? share_gone(time_s, wanted < veil_share_ ? kVeilFall_s : config_.veil_rise_s) : 1.0);
  veil_known_ = true;
  if (!profile_.valid) {
    profile_ = profile;
  } else {
    const std::array<float, kRangeBins> before = profile_.range_m;
    profile_ = profile;
    const auto share = static_cast<float>(share_gone(time_s, config_.range_smoothing_s));
    for (std::size_t bin = 0; bin < kRangeBins; ++bin)
      profile_.range_m[bin] = before[bin] * std::pow(profile.range_m[bin] / before[bin], share);
  }
  if (moved_ >= 1.0) keep_edges(profile_);
}

void RangeMemory::keep_edges(const RangeProfile& profile) noexcept {
  moved_ = 0.0;
  float longest = 0.0f;
  for (const float range_m : profile.range_m) longest = std::max(longest, range_m);
  for (const std::size_t bin : {kEdgeBin, kRangeBins - 1 - kEdgeBin})
    if (profile.range_m[bin] < kSeenShare * longest)
      keep(profile.azimuth_rad(static_cast<int>(bin)), static_cast<double>(profile.range_m[bin]));
}

void RangeMemory::keep(double azimuth_rad, double range_m) noexcept {
  if (beside_count_ == kBesideMax) {
    std::copy(beside_.begin() + 1, beside_.end(), beside_.begin());
    --beside_count_;
  }
  beside_[beside_count_++] = {static_cast<float>(range_m * std::cos(azimuth_rad)),
                              static_cast<float>(range_m * std::sin(azimuth_rad)), 0.0f};
}

}  // namespace adit
