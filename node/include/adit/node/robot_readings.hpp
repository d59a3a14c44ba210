// What a robot's sensors say, in plain numbers: made by the simulated robot, written to bags and topics.
#pragma once

#include <array>
#include <vector>

namespace adit::node {

/// Place and attitude of one frame in another, as in geometry_msgs/Transform.
struct Placement {
  std::array<double, 3> place_m{};
  std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};  ///< x, y, z, w
};

struct RobotMotion {
  Placement in_world;                          ///< of the body: x forward, y left, z up
  std::array<double, 3> velocity_m_s{};        ///< body frame
  std::array<double, 3> angular_rate_rad_s{};  ///< body frame
};

struct ImuReading {
  double stamp_s = 0.0;
  std::array<double, 3> angular_rate_rad_s{};
  std::array<double, 3> specific_force_m_s2{};
};

/// One sweep in the body's plane, from right to left.
struct ScanReading {
  double stamp_s = 0.0, angle_min_rad = 0.0, angle_step_rad = 0.0;
  double interval_s = 0.0, range_min_m = 0.0, range_max_m = 0.0;
  std::vector<float> ranges_m;  ///< infinity where nothing is within range
};

}  // namespace adit::node
