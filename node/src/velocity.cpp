#include "adit/node/velocity.hpp"

namespace adit::node {

PositionTargetFields position_target_of(const VelocityCommand& command) noexcept {
  constexpr std::uint16_t kVelocityAndYawRate =
      kIgnorePx | kIgnorePy | kIgnorePz | kIgnoreAfx | kIgnoreAfy | kIgnoreAfz | kIgnoreYaw;
  return {kFrameBodyNed, kVelocityAndYawRate, command.forward_m_s, 0.0, 0.0, command.yaw_rate_rad_s};
}

}  // namespace adit::node
