// The simulator as a robot: sensors out, velocity commands in. What it is steered by is none of its business.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/image.hpp"
#include "adit/node/robot_readings.hpp"

namespace adit::node {

struct SimulatedRobotConfig {
  std::string course_file;            ///< courses/NAME.yaml
  std::string lamp = "flood_460lux";  ///< see sim::rig_preset_names()
  double dust_1_m = 0.0;              ///< extinction, 0 to 0.5
  int width = 640;                    ///< px
  int height = 480;                   ///< px
  std::uint64_t seed = 1;             ///< of gusts and noise
  double camera_rate_hz = 30.0;       ///< 1 to 120
  double time_max_s = 120.0;
  int threads = 0;  ///< of the renderer; 0: all of the machine
};

/// One robot in one course, from the middle of its start. Same commands, same flight.
class SimulatedRobot {
 public:
  /// @throws std::invalid_argument naming the field or file, the value and what to do.
  explicit SimulatedRobot(const SimulatedRobotConfig& config);
  ~SimulatedRobot();

  [[nodiscard]] double time_s() const noexcept { return time_s_; }
  [[nodiscard]] const Camera& camera() const noexcept;
  /// Of the optical frame in the body's.
  [[nodiscard]] Placement camera_in_body() const;
  [[nodiscard]] RobotMotion motion() const;

  /// Takes a frame at time_s(); it stays valid until the next.
  [[nodiscard]] ImageView look();
  /// Flies until the next frame. @param yaw_rate_rad_s  positive to the left. @return false when the flight is over:
  /// see outcome().
  bool fly(double forward_m_s, double yaw_rate_rad_s);

  /// Of the last interval.
  [[nodiscard]] const std::vector<ImuReading>& imu() const noexcept { return imu_; }
  [[nodiscard]] const std::optional<ScanReading>& scan() const noexcept { return scan_; }

  /// Empty while it flies; "goal", "collided" or "timeout". It never stops by itself: whoever is told to hover hovers
  /// until time_max_s.
  [[nodiscard]] const std::string& outcome() const noexcept { return outcome_; }
  /// Smallest distance from the body's centre to rock so far, m.
  [[nodiscard]] double clearance_min_m() const noexcept { return clearance_min_m_; }
  [[nodiscard]] double distance_m() const noexcept { return distance_m_; }

 private:
  struct Parts;
  void sweep();
  void judge();

  SimulatedRobotConfig config_;
  std::unique_ptr<Parts> parts_;
  double time_s_ = 0.0;
  std::int64_t frames_ = 0;
  double distance_m_ = 0.0;
  double clearance_min_m_ = 1e9;
  std::vector<ImuReading> imu_;
  std::optional<ScanReading> scan_;
  std::string outcome_;
};

}  // namespace adit::node
