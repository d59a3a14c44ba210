// The controller node: topics around adit::node::Control.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <string>

#include "adit/node/control.hpp"
#include "field_server.hpp"
#include "launch_parameters.hpp"
#include "messages.hpp"

namespace adit_ros1 {

class ControllerNode {
 public:
  /// @throws std::invalid_argument naming the parameter, the value and the range.
  ControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& name);

 private:
  void take_open_space(const adit_ros1::OpenSpaceConstPtr& message);
  void take_heading(const geometry_msgs::TwistStampedConstPtr& message);
  void tick();
  void publish(const adit::node::VelocityCommand& command);
  FieldServer::Fields fields();

  ros::NodeHandle nh_;
  adit::node::ControlLaunch launch_;
  adit::node::Control control_;
  FieldServer parameters_;
  diagnostic_updater::Updater updater_;
  ros::Subscriber open_space_, heading_;
  ros::Publisher cmd_vel_, setpoint_velocity_, setpoint_raw_, latency_, state_;
  ros::SteadyTimer ticks_;
  ros::WallTimer report_;
  std::string last_state_;
};

}  // namespace adit_ros1
