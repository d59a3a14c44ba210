// A tunnel drawn as a plan: upright walls, flat floor and roof, lit by a lamp at the camera. Seen and flown through in
// milliseconds, by a point that moves as it is told.
#pragma once

#include <vector>

#include "adit/navigator.hpp"
#include "frames.hpp"

namespace adit::test {

struct PlanPoint {
  double x_m = 0.0, y_m = 0.0;
};

struct PlanPose {
  double x_m = 0.0, y_m = 0.0;
  double yaw_rad = 0.0;  ///< from x to y, to the left
};

struct LitPlan {
  struct Wall {
    PlanPoint from, to;
  };
  std::vector<Wall> walls;
  double eye_m = 1.0;   ///< over the floor
  double roof_m = 3.5;  ///< over the floor
  double reach_light = 8.0;
  double extinction_1_m = 0.0;  ///< of dust
  double veil = 0.0;            ///< light that dust throws back

  /// Walls to both sides of a line, mitred at its corners; closed at its ends where wanted.
  void add_passage(const std::vector<PlanPoint>& line, double width_m, bool closed_at_end, bool closed_at_begin);
  /// The same tunnel with left and right exchanged (y turned round).
  [[nodiscard]] LitPlan mirrored() const;

  /// What a pinhole camera of 75 degrees sees, with the fall-off that ColumnRangeConfig expects; exposed so that its
  /// mean is about 80. @param seed of the noise; 0: none.
  [[nodiscard]] Frame seen_from(const PlanPose& pose, unsigned seed, int width = 80, int height = 60) const;
  /// Horizontal range, divided by the root of the incidence's cosine: what brightness says of it.
  [[nodiscard]] double pseudo_range_m(const PlanPose& pose, double azimuth_rad) const;
  /// To the nearest wall.
  [[nodiscard]] double clearance_m(const PlanPose& pose) const;
};

/// A flight through a plan: 1 m/s at the most, 20 frames a second, lags of speed and yaw as the simulator's.
struct PlanFlight {
  PlanFlight(const LitPlan& flown, const PlanPose& start, const NavigatorConfig& config)
      : plan(&flown), pose(start), navigator(config) {}

  const LitPlan* plan;
  PlanPose pose;
  Navigator navigator;
  double time_s = 0.0;
  double speed_m_s = 0.0, yaw_rate_rad_s = 0.0;
  double clearance_min_m = 1e9;
  double turned_rad = 0.0;  ///< in all, to the left
  NavigatorCommand command;

  /// A frame, a command, and the way to the next frame.
  void step();
};

}  // namespace adit::test
