// The controller component: topics around adit::node::Control. The same topics and names as adit_ros1's.
#include <chrono>
#include <diagnostic_updater/diagnostic_updater.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>

#include "adit/node/control.hpp"
#include "adit/node/launch_config.hpp"
#include "adit_ros2/msg/open_space.hpp"
#include "parameters.hpp"

namespace adit_ros2 {

class ControllerNode : public rclcpp::Node {
 public:
  explicit ControllerNode(const rclcpp::NodeOptions& options)
      : Node("controller", options),
        updater_(this),
        body_frame_(declare_parameter("body_frame", adit::node::ControlLaunch().body_frame)) {
    handle_ = serve(*this, {[this] { return control_.parameters(); },
                            [this](const std::string& name, const adit::node::ParameterValue& value) {
                              return control_.set(name, value);
                            },
                            [this] { control_.apply(); }});
    cmd_vel_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 1);
    setpoint_velocity_ = create_publisher<geometry_msgs::msg::TwistStamped>("setpoint_velocity/cmd_vel", 1);
    latency_ = create_publisher<std_msgs::msg::Float64>("latency", 10);
    // Up to Iron, a publisher that remembers its last message cannot be one within the process.
    rclcpp::PublisherOptions across_processes;
    across_processes.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
    state_ =
        create_publisher<std_msgs::msg::String>("controller_state", rclcpp::QoS(1).transient_local(), across_processes);
    open_space_ = create_subscription<msg::OpenSpace>("open_space", 10, [this](const msg::OpenSpace& m) { take(m); });
    heading_ = create_subscription<geometry_msgs::msg::TwistStamped>(
        "heading", 1, [this](const geometry_msgs::msg::TwistStamped& m) { take(m); });
    updater_.setHardwareID("none");
    updater_.add("controller", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
      const auto d = control_.diagnosis(now().nanoseconds());
      status.summary(static_cast<std::uint8_t>(d.level), d.message);
      for (const auto& [key, value] : d.values) status.add(key, value);
    });
    // How often it looks does not depend on a simulated clock, nor on one that somebody sets; what is fresh is judged
    // by ROS time. While a simulated clock stands still the world does, too, and nothing grows old.
    ticks_ = create_wall_timer(std::chrono::milliseconds(50), [this] { tick(); });
  }

 private:
  void take(const msg::OpenSpace& m) {
    const auto status = m.status < adit::kStatusCount ? static_cast<adit::Status>(m.status) : adit::Status::kBadFrame;
    control_.take(adit::node::OpenSpaceNews{rclcpp::Time(m.header.stamp).nanoseconds(), status,
                                            m.manoeuvre == msg::OpenSpace::MANOEUVRE_TURN},
                  now().nanoseconds());
  }

  void take(const geometry_msgs::msg::TwistStamped& m) {
    const auto stamp_ns = rclcpp::Time(m.header.stamp).nanoseconds();
    const auto command =
        control_.take(adit::node::HeadingNews{stamp_ns, m.twist.linear.x, m.twist.angular.z}, now().nanoseconds());
    if (!command) return;
    publish(*command);
    if (command->is_hover) return;
    std_msgs::msg::Float64 latency;
    latency.data = adit::node::seconds_of(now().nanoseconds() - stamp_ns);
    latency_->publish(latency);
  }

  void tick() {
    const auto time_ns = now().nanoseconds();
    if (time_ns == 0) return;  // the simulated clock has not begun
    if (const auto command = control_.tick(time_ns)) publish(*command);
    std_msgs::msg::String state;
    state.data = control_.alarm_text(time_ns);
    if (state.data == last_state_) return;
    last_state_ = state.data;
    state_->publish(state);
    if (state.data != "following") RCLCPP_WARN(get_logger(), "hover: %s", state.data.c_str());
  }

  void publish(const adit::node::VelocityCommand& command) {
    geometry_msgs::msg::TwistStamped m;
    m.header.stamp = now();
    m.header.frame_id = body_frame_;
    m.twist.linear.x = command.forward_m_s;
    m.twist.angular.z = command.yaw_rate_rad_s;
    cmd_vel_->publish(m.twist);
    setpoint_velocity_->publish(m);
  }

  adit::node::Control control_;
  diagnostic_updater::Updater updater_;
  std::string body_frame_, last_state_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr cmd_vel_;
  rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr setpoint_velocity_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr latency_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_;
  rclcpp::Subscription<msg::OpenSpace>::SharedPtr open_space_;
  rclcpp::Subscription<geometry_msgs::msg::TwistStamped>::SharedPtr heading_;
  rclcpp::TimerBase::SharedPtr ticks_;
};

}  // namespace adit_ros2

RCLCPP_COMPONENTS_REGISTER_NODE(adit_ros2::ControllerNode)
