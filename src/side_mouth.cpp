#include "adit/side_mouth.hpp"

#include <algorithm>
#include <array>

#include "share_gone.hpp"

namespace adit {
namespace {

/// Bins at the edge of the frame that are looked at, without the outermost: 6 degrees of a common lens.
constexpr std::size_t kFirstBin = 1, kBins = 5;
/// The wall counts as gone from this times its range on: albedo, which a range goes with the root of, makes 1.2 of it;
/// a passage as wide as the drift makes 2.
constexpr double kGoneShare = 1.45;
/// Recesses and niches are shorter than this, passages longer.
constexpr double kGone_m = 0.6;
/// Way over which a wall's range is smoothed, and over which it has to be seen before it can be missed.
constexpr double kWallLag_m = 2.0, kWallKnown_m = 1.5;
/// What a mouth taken turns the vehicle by at the most: rather less than a right angle, the passage's own gap is ahead
/// by then.
constexpr double kTurn_rad = 1.3;
/// At the edge of a common lens: further aside nothing is seen of the way.
constexpr double kAside_rad = 0.55;
/// A mouth not taken in this time, at 1 m/s twice the way through it, has been missed.
constexpr double kTaking_s = 8.0;

double median_beside(const RangeProfile& profile, double side) noexcept {
  std::array<float, kBins> ranges;
  for (std::size_t i = 0; i < kBins; ++i) {
    const std::size_t from_edge = kFirstBin + i;
    ranges[i] = profile.range_m[side > 0.0 ? kRangeBins - 1 - from_edge : from_edge];
  }
  std::nth_element(ranges.begin(), ranges.begin() + kBins / 2, ranges.end());
  return static_cast<double>(ranges[kBins / 2]);
}

}  // namespace

std::optional<double> SideMouth::update(const RangeProfile& profile, double side, const Step& step) noexcept {
  if (!taking_) {
    watch(median_beside(profile, side), std::max(step.forward_m, 0.0));
    if (gone_m_ < kGone_m) return std::nullopt;
    *this = {};
    taking_ = true;
  }
  turned_rad_ -= side * step.yaw_rad;  // yaw is positive to the left
  taking_s_ += step.time_s;
  if (turned_rad_ >= kTurn_rad || taking_s_ >= kTaking_s) {
    *this = {};
    return std::nullopt;
  }
  return side * std::min(kAside_rad, kTurn_rad - turned_rad_);
}

void SideMouth::watch(double beside_m, double forward_m) noexcept {
  if (known_m_ >= kWallKnown_m && beside_m > kGoneShare * wall_m_) {
    gone_m_ += forward_m;
    return;
  }
  gone_m_ = 0.0;
  if (!(wall_m_ > 0.0)) wall_m_ = beside_m;
  wall_m_ += share_gone(forward_m, kWallLag_m) * (beside_m - wall_m_);
  known_m_ += forward_m;
}

}  // namespace adit
