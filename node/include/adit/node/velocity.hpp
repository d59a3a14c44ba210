// What a vehicle is told, and how MAVROS wants to hear it.
#pragma once

#include <cstdint>

#include "adit/heading.hpp"
#include "adit/node/time.hpp"

namespace adit::node {

/// Body frame (x forward, y left, z up), REP 103: yaw rate positive counter-clockwise, seen from above.
struct VelocityCommand {
  Time_ns stamp_ns = 0;  ///< of the frame it was made from; of a hover: when it was ordered
  double forward_m_s = 0.0;
  double yaw_rate_rad_s = 0.0;
  bool is_hover = false;  ///< zero, because nothing fresh is known
};

/// mavros_msgs/PositionTarget, field by field, of a velocity and a yaw rate in the body frame.
/// MAVROS takes FLU (x forward, y left, z up) and turns it into the autopilot's FRD itself: no sign is turned here.
struct PositionTargetFields {
  std::uint8_t coordinate_frame = 0;
  std::uint16_t type_mask = 0;
  double velocity_x = 0.0, velocity_y = 0.0, velocity_z = 0.0;  ///< m/s
  double yaw_rate = 0.0;                                        ///< rad/s
};

// Of the message definition (mavros_msgs 1.x, PositionTarget.msg), so that the conversion can be tested without it.
inline constexpr std::uint8_t kFrameBodyNed = 8;
inline constexpr std::uint16_t kIgnorePx = 1, kIgnorePy = 2, kIgnorePz = 4;
inline constexpr std::uint16_t kIgnoreVx = 8, kIgnoreVy = 16, kIgnoreVz = 32;
inline constexpr std::uint16_t kIgnoreAfx = 64, kIgnoreAfy = 128, kIgnoreAfz = 256;
inline constexpr std::uint16_t kForce = 512;
inline constexpr std::uint16_t kIgnoreYaw = 1024, kIgnoreYawRate = 2048;

/// Velocity and yaw rate count; place, acceleration and yaw do not. The vertical velocity is 0: height is held.
[[nodiscard]] PositionTargetFields position_target_of(const VelocityCommand& command) noexcept;

}  // namespace adit::node
