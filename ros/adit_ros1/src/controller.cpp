#include "controller.hpp"

#include <std_msgs/Float64.h>
#include <std_msgs/String.h>

#include "adit/node/velocity.hpp"
#include "names.hpp"
#ifdef ADIT_WITH_MAVROS
#include <mavros_msgs/PositionTarget.h>
#endif

namespace adit_ros1 {
namespace {

// The rate of hover commands: autopilots leave offboard mode when they hear less than 2 Hz.
constexpr double kTickEach_s = 0.05;
constexpr double kReportEach_s = 1.0;

adit::node::Time_ns now() { return time_of(ros::Time::now()); }

#ifdef ADIT_WITH_MAVROS
mavros_msgs::PositionTarget position_target_of(const adit::node::VelocityCommand& command, const ros::Time& stamp,
                                               const std::string& frame_id) {
  const adit::node::PositionTargetFields f = adit::node::position_target_of(command);
  mavros_msgs::PositionTarget m;
  m.header.stamp = stamp;
  m.header.frame_id = frame_id;
  m.coordinate_frame = f.coordinate_frame;
  m.type_mask = f.type_mask;
  m.velocity.x = f.velocity_x;
  m.velocity.y = f.velocity_y;
  m.velocity.z = f.velocity_z;
  m.yaw_rate = static_cast<float>(f.yaw_rate);
  return m;
}
#endif

}  // namespace

ControllerNode::ControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& name)
    : nh_(nh),
      launch_(launch_parameters<adit::node::ControlLaunch>(private_nh)),
      parameters_(private_nh, fields()),
      updater_(nh, private_nh, name) {
  const auto beside = [&](const char* topic) { return name_beside(private_nh, topic); };
  cmd_vel_ = nh_.advertise<geometry_msgs::Twist>(beside("cmd_vel"), 1);
  setpoint_velocity_ = nh_.advertise<geometry_msgs::TwistStamped>(beside("setpoint_velocity/cmd_vel"), 1);
#ifdef ADIT_WITH_MAVROS
  setpoint_raw_ = nh_.advertise<mavros_msgs::PositionTarget>(beside("setpoint_raw/local"), 1);
#endif
  latency_ = nh_.advertise<std_msgs::Float64>(beside("latency"), 10);
  state_ = nh_.advertise<std_msgs::String>(beside("controller_state"), 1, true);
  const auto no_delay = ros::TransportHints().tcpNoDelay();
  open_space_ = nh_.subscribe(beside("open_space"), 10, &ControllerNode::take_open_space, this, no_delay);
  heading_ = nh_.subscribe(beside("heading"), 1, &ControllerNode::take_heading, this, no_delay);
  updater_.setHardwareID("none");
  updater_.add("controller", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    if (!ros::Time::now().isZero()) fill(status, control_.diagnosis(now()));
  });
  // How often it looks does not depend on a simulated clock, nor on one that somebody sets; what is fresh is judged by
  // ROS time. While a simulated clock stands still the world does, too, and nothing grows old.
  ticks_ = nh_.createSteadyTimer(ros::WallDuration(kTickEach_s), [this](const ros::SteadyTimerEvent&) { tick(); });
  report_ = nh_.createWallTimer(ros::WallDuration(kReportEach_s),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

FieldServer::Fields ControllerNode::fields() {
  return {
      [this] { return control_.parameters(); },
      [this](const std::string& name, const adit::node::ParameterValue& value) { return control_.set(name, value); },
      [this] { control_.apply(); }};
}

void ControllerNode::take_open_space(const adit_ros1::OpenSpaceConstPtr& m) {
  const bool is_known = m->status < adit::kStatusCount;
  const auto status = is_known ? static_cast<adit::Status>(m->status) : adit::Status::kBadFrame;
  control_.take(
      adit::node::OpenSpaceNews{time_of(m->header.stamp), status, m->manoeuvre == adit_ros1::OpenSpace::MANOEUVRE_TURN},
      now());
}

void ControllerNode::take_heading(const geometry_msgs::TwistStampedConstPtr& m) {
  const auto command =
      control_.take(adit::node::HeadingNews{time_of(m->header.stamp), m->twist.linear.x, m->twist.angular.z}, now());
  if (!command) return;
  publish(*command);
  if (command->is_hover) return;
  std_msgs::Float64 latency;
  latency.data = (ros::Time::now() - m->header.stamp).toSec();
  latency_.publish(latency);
}

void ControllerNode::tick() {
  if (ros::Time::now().isZero()) return;  // the simulated clock has not begun
  const auto command = control_.tick(now());
  if (command) publish(*command);
  const std::string state = control_.alarm_text(now());
  if (state == last_state_) return;
  last_state_ = state;
  std_msgs::String m;
  m.data = state;
  state_.publish(m);
  if (state != "following") ROS_WARN("hover: %s", state.c_str());
}

void ControllerNode::publish(const adit::node::VelocityCommand& command) {
  geometry_msgs::TwistStamped stamped;
  stamped.header.stamp = ros::Time::now();
  stamped.header.frame_id = launch_.body_frame;
  stamped.twist = twist_of(command);
  cmd_vel_.publish(stamped.twist);
  setpoint_velocity_.publish(stamped);
#ifdef ADIT_WITH_MAVROS
  setpoint_raw_.publish(position_target_of(command, stamped.header.stamp, launch_.body_frame));
#endif
}

}  // namespace adit_ros1
