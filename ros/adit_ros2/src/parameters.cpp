#include "parameters.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace adit_ros2 {
namespace {

using adit::node::Parameter;
using adit::node::ParameterValue;

rcl_interfaces::msg::ParameterDescriptor descriptor_of(const Parameter& p) {
  rcl_interfaces::msg::ParameterDescriptor d;
  d.description = p.meaning + (p.unit.empty() ? "" : " Unit: " + p.unit + ".") + " (" + p.source + ")";
  for (const std::string& choice : p.choices) d.additional_constraints += choice + " ";
  if (std::holds_alternative<double>(p.value)) {
    d.floating_point_range.resize(1);
    d.floating_point_range[0].from_value = p.minimum;
    d.floating_point_range[0].to_value = p.maximum;
  } else if (std::holds_alternative<int>(p.value)) {
    d.integer_range.resize(1);
    d.integer_range[0].from_value = static_cast<std::int64_t>(p.minimum);
    d.integer_range[0].to_value = static_cast<std::int64_t>(p.maximum);
    d.integer_range[0].step = 1;
  }
  return d;
}

rclcpp::ParameterValue value_of(const ParameterValue& value) {
  return std::visit([](const auto& v) { return rclcpp::ParameterValue(v); }, value);
}

/// Nothing for types that no field has.
bool value_of(const rclcpp::Parameter& p, ParameterValue& value) {
  switch (p.get_type()) {
    case rclcpp::ParameterType::PARAMETER_BOOL:
      value = p.as_bool();
      return true;
    case rclcpp::ParameterType::PARAMETER_INTEGER:
      value = static_cast<int>(p.as_int());
      return true;
    case rclcpp::ParameterType::PARAMETER_DOUBLE:
      value = p.as_double();
      return true;
    case rclcpp::ParameterType::PARAMETER_STRING:
      value = p.as_string();
      return true;
    default:
      return false;
  }
}

std::string take(const Fields& fields, const std::map<std::string, bool>& known,
                 const std::vector<rclcpp::Parameter>& parameters) {
  const auto before = fields.list();
  std::string why;
  for (const rclcpp::Parameter& p : parameters) {
    ParameterValue value;
    if (!known.count(p.get_name()) || !why.empty()) continue;
    why = value_of(p, value) ? fields.set(p.get_name(), value) : p.get_name() + ": a value of the wrong type";
  }
  try {
    if (why.empty()) fields.apply();
  } catch (const std::invalid_argument& e) {
    why = e.what();
  }
  if (!why.empty())
    for (const Parameter& p : before) (void)fields.set(p.name, p.value);
  return why;
}

}  // namespace

rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr serve(rclcpp::Node& node, Fields fields) {
  std::map<std::string, bool> known;
  for (const Parameter& p : fields.list()) {
    node.declare_parameter(p.name, value_of(p.value), descriptor_of(p));
    ParameterValue value;
    if (value_of(node.get_parameter(p.name), value))
      if (const std::string why = fields.set(p.name, value); !why.empty()) throw std::invalid_argument(why);
    known[p.name] = true;
  }
  fields.apply();
  return node.add_on_set_parameters_callback([fields, known](const std::vector<rclcpp::Parameter>& parameters) {
    rcl_interfaces::msg::SetParametersResult result;
    result.reason = take(fields, known, parameters);
    result.successful = result.reason.empty();
    return result;
  });
}

}  // namespace adit_ros2
