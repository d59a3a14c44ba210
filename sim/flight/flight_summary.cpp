#include "adit/sim/flight_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::sim {
namespace {

double difference_deg(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * std::numbers::pi)) * 180.0 / std::numbers::pi;
}

/// The smaller one, whatever is not known yet.
double smaller(double known, double value) { return value < known || std::isnan(known) ? value : known; }

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&values](double share) {
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  return {at(0.5), at(0.95)};
}

void FlightTally::Spell::add(bool holds, double stamp_s) {
  if (!holds) {
    since_s.reset();
    counted = false;
    return;
  }
  if (!since_s) since_s = stamp_s;
  if (counted || stamp_s - *since_s < kStopCounts_s) return;
  counted = true;
  ++count;
}

void FlightTally::add(const FlightRow& row) {
  ++frames_;
  last_truth_ = row.truth;
  clearance_min_m_ = smaller(clearance_min_m_, row.truth.clearance_m);
  side_clearance_min_m_ = smaller(side_clearance_min_m_, row.truth.side_clearance_m);
  side_clearances_m_.push_back(row.truth.side_clearance_m);
  // Azimuth is to the right of the nose, the world's angles to its left.
  bend_count_.add(row.vehicle.place, row.vehicle.yaw_rad - row.truth.passage.azimuth_rad);
  const bool holds = row.command.state == HeadingState::kHold;
  false_stop_.add(holds && row.truth.opening_in_sight, row.stamp_s);
  missed_stop_.add(!holds && !row.truth.opening_in_sight, row.stamp_s);
  if (row.delivery == Delivery::kDropped) {
    ++dropped_;
    return;
  }
  if (row.delivery == Delivery::kRepeated) {
    ++repeated_;
    return;  // its pixels are of another pose: no error, no jitter can be taken from it
  }
  if (row.status != Status::kFound) {
    last_sx_.reset();
    return;
  }
  ++found_;
  if (std::isfinite(row.truth.passage.azimuth_rad))
    passage_errors_deg_.push_back(difference_deg(row.bearing.azimuth_rad, row.truth.passage.azimuth_rad));
  if (std::isfinite(row.truth.deepest.azimuth_rad))
    deepest_errors_deg_.push_back(difference_deg(row.bearing.azimuth_rad, row.truth.deepest.azimuth_rad));
  if (last_sx_) {
    const double change = row.point.sx - *last_sx_;
    sx_squares_ += change * change;
    ++sx_steps_;
  }
  last_sx_ = row.point.sx;
}

FlightSummary FlightTally::of(const Flight& flight) const {
  FlightSummary s;
  s.outcome = flight.outcome().value_or(Outcome::kTimeout);
  s.reason = flight.reason();
  s.seed = flight.settings().seed;
  s.duration_s = flight.time_s();
  s.distance_m = flight.distance_m();
  s.progress_m = last_truth_.progress_m;
  s.to_goal_m = last_truth_.to_goal_m;
  s.bends = bend_count_.bends();
  s.frames = frames_;
  s.dropped_frames = dropped_;
  s.repeated_frames = repeated_;
  s.side_clearance_min_m = side_clearance_min_m_;
  s.clearance_min_m = clearance_min_m_;
  if (s.outcome == Outcome::kCollided) {
    s.side_clearance_min_m = smaller(s.side_clearance_min_m, flight.touched_side_m());
    s.clearance_min_m = smaller(s.clearance_min_m, flight.settings().vehicle.body_radius_m);
  }
  s.side_clearance_median_m = spread_of(side_clearances_m_).median;
  s.heading_error_passage_deg = spread_of(passage_errors_deg_);
  s.heading_error_deepest_deg = spread_of(deepest_errors_deg_);
  if (sx_steps_ > 0) s.sx_jitter = std::sqrt(sx_squares_ / static_cast<double>(sx_steps_));
  const std::int64_t judged = frames_ - dropped_ - repeated_;
  if (judged > 0) s.found_fraction = static_cast<double>(found_) / static_cast<double>(judged);
  s.false_stops = false_stop_.count;
  s.missed_stops = missed_stop_.count;
  return s;
}

Rate wilson_rate(int successes, int trials) {
  Rate rate{successes, trials, kUnknown, 0.0, 1.0};
  if (trials <= 0) return rate;
  constexpr double kZ = 1.959963984540054;
  const double n = trials, p = successes / n, z2 = kZ * kZ;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = kZ / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  rate.rate = p;
  rate.low = std::max(0.0, middle - half);
  rate.high = std::min(1.0, middle + half);
  return rate;
}

}  // namespace adit::sim
