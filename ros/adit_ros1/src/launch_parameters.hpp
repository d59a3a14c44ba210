// Parameters of a node's start, from the parameter server into a struct of adit/node/launch_config.hpp.
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "adit/node/launch_config.hpp"

namespace adit_ros1 {

/// Nothing where it is not set. @throws std::invalid_argument for lists and the like.
inline std::optional<adit::node::ParameterValue> parameter_at(const ros::NodeHandle& private_nh,
                                                              const std::string& name) {
  XmlRpc::XmlRpcValue value;
  if (!private_nh.getParam(name, value)) return std::nullopt;
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpc::XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpc::XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      throw std::invalid_argument(private_nh.getNamespace() + "/" + name + ": neither number, text nor boolean");
  }
}

/// The defaults, but what is set. @throws std::invalid_argument naming the parameter, the value and the range.
template <class Launch>
Launch launch_parameters(const ros::NodeHandle& private_nh) {
  Launch launch;
  for (const adit::node::Parameter& p : parameters_of(launch)) {
    const auto value = parameter_at(private_nh, p.name);
    if (!value) continue;
    if (const std::string why = set_parameter(launch, p.name, *value); !why.empty())
      throw std::invalid_argument(private_nh.getNamespace() + ": " + why);
  }
  return launch;
}

}  // namespace adit_ros1
