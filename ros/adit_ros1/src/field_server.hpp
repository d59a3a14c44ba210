// Parameters by YAML at the start, and live by dynamic_reconfigure: both made from the fields of the structs, so that a
// new field is a parameter without a line of code here. It speaks dynamic_reconfigure's topics and service itself: the
// package's own server is made from a list that would repeat names, ranges and defaults.
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/ros.h>

#include <functional>
#include <string>
#include <vector>

#include "adit/node/parameters.hpp"

namespace adit_ros1 {

class FieldServer {
 public:
  /// What the server serves.
  struct Fields {
    std::function<std::vector<adit::node::Parameter>()> list;
    /// Why a value is refused; "" when it is taken. Nothing happens before apply().
    std::function<std::string(const std::string& name, const adit::node::ParameterValue&)> set;
    std::function<void()> apply;  ///< @throws std::invalid_argument
  };

  /// Reads what the parameter server has, applies it, and goes on the air.
  /// @throws std::invalid_argument naming the parameter, the value and the range.
  FieldServer(const ros::NodeHandle& private_nh, Fields fields);

 private:
  void read_parameters();
  bool reconfigure(dynamic_reconfigure::Reconfigure::Request& request,
                   dynamic_reconfigure::Reconfigure::Response& response);
  void take(const std::string& name, const adit::node::ParameterValue& value);
  [[nodiscard]] dynamic_reconfigure::Config present() const;
  [[nodiscard]] dynamic_reconfigure::ConfigDescription description() const;
  void announce();

  ros::NodeHandle nh_;
  Fields fields_;
  std::vector<adit::node::Parameter> defaults_;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer service_;
};

}  // namespace adit_ros1
