// A flight in a few figures, and many flights in a rate with its interval.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/sim/bend_count.hpp"
#include "adit/sim/flight.hpp"

namespace adit::sim {

/// Median and 95th percentile of what was gathered; NaN when nothing was.
struct Spread {
  double median = kUnknown;
  double p95 = kUnknown;
};

/// Nearest-rank percentiles. @param values  taken by value: they are sorted.
[[nodiscard]] Spread spread_of(std::vector<double> values);

/// The figures of a flight. Distances to rock are from the body's centre; a collision counts as body_radius_m.
struct FlightSummary {
  Outcome outcome = Outcome::kTimeout;
  std::string reason;
  std::uint64_t seed = 0;
  double duration_s = 0.0;
  double distance_m = 0.0;       ///< flown
  double progress_m = kUnknown;  ///< along the route; NaN without a layout
  double to_goal_m = kUnknown;   ///< left at the end; NaN or infinity where there is none
  int bends = 0;                 ///< passed: see BendCount
  std::int64_t frames = 0;
  std::int64_t dropped_frames = 0;
  std::int64_t repeated_frames = 0;
  double side_clearance_min_m = kUnknown;     ///< over horizontal rays
  double side_clearance_median_m = kUnknown;  ///< of the frames' smallest horizontal ranges
  double clearance_min_m = kUnknown;          ///< over all directions: floor and roof too
  Spread heading_error_passage_deg;  ///< found frames: |azimuth - azimuth of the passage look_ahead_m further on|
  Spread heading_error_deepest_deg;  ///< found frames: |azimuth - azimuth of the deepest direction in sight|
  double sx_jitter = kUnknown;       ///< root mean square of the change of sx from a found frame to the next
  double found_fraction = kUnknown;  ///< of the frames that arrived
  int false_stops = 0;               ///< held for kStopCounts_s although an opening was in sight
  int missed_stops = 0;              ///< flew on for kStopCounts_s although none was
};

inline constexpr double kStopCounts_s = 0.5;

/// Gathers the rows of a flight.
class FlightTally {
 public:
  void add(const FlightRow& row);
  /// The figures, once the flight is over.
  [[nodiscard]] FlightSummary of(const Flight& flight) const;

 private:
  /// Counts spells of a condition that last.
  struct Spell {
    std::optional<double> since_s;
    bool counted = false;
    int count = 0;
    void add(bool holds, double stamp_s);
  };

  std::int64_t frames_ = 0, dropped_ = 0, repeated_ = 0, found_ = 0;
  std::vector<double> passage_errors_deg_, deepest_errors_deg_, side_clearances_m_;
  double clearance_min_m_ = kUnknown;
  double side_clearance_min_m_ = kUnknown;
  std::optional<double> last_sx_;
  double sx_squares_ = 0.0;
  std::int64_t sx_steps_ = 0;
  Spell false_stop_, missed_stop_;
  BendCount bend_count_;
  Truth last_truth_;
};

/// A share of successes and the interval it is known to lie in.
struct Rate {
  int successes = 0;
  int trials = 0;
  double rate = kUnknown;
  double low = 0.0;
  double high = 1.0;
};

/// Wilson's score interval (Wilson, 1927) at 95 %.
[[nodiscard]] Rate wilson_rate(int successes, int trials);

}  // namespace adit::sim
