// What a person may set of the controller node.
#pragma once

#include <optional>
#include <string>

namespace adit::node {

/// Unit, range and source of each field stand in visit_fields() (settings.hpp).
struct ControlConfig {
  double hover_after_s = 0.5;
  double error_after_s = 5.0;
  double speed_max_m_s = 1.0;
  double yaw_rate_limit_rad_s = 0.8;
  bool turn_without_opening = false;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const ControlConfig& config);

}  // namespace adit::node
