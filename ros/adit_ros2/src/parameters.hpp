// Parameters made from the fields of adit's structs: declared with ranges, and taken live.
#pragma once

#include <functional>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

#include "adit/node/parameters.hpp"

namespace adit_ros2 {

struct Fields {
  std::function<std::vector<adit::node::Parameter>()> list;
  std::function<std::string(const std::string&, const adit::node::ParameterValue&)> set;
  std::function<void()> apply;  ///< @throws std::invalid_argument
};

/// Declares all, takes what is set already, and answers later changes. Keep what is returned.
/// @throws rclcpp::exceptions::InvalidParameterValueException, std::invalid_argument
[[nodiscard]] rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr serve(rclcpp::Node& node,
                                                                                      Fields fields);

}  // namespace adit_ros2
