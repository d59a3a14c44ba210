#include "sim.hpp"

#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>

#include <cmath>

#include "launch_parameters.hpp"
#include "sim_messages.hpp"

namespace adit_ros1 {
namespace {

constexpr const char* kOpticalFrame = "camera_optical";

}  // namespace

struct SimNode::Picture {
  sensor_msgs::Image image;
  sensor_msgs::CameraInfo info;
};

SimNode::SimNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : nh_(nh),
      launch_(launch_parameters<adit::node::SimLaunch>(private_nh)),
      robot_(std::make_unique<adit::node::SimulatedRobot>(launch_.robot)) {
  clock_ = nh_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  image_ = nh_.advertise<sensor_msgs::Image>("camera/image_raw", 2);
  camera_info_ = nh_.advertise<sensor_msgs::CameraInfo>("camera/camera_info", 2);
  odom_ = nh_.advertise<nav_msgs::Odometry>("odom", 10);
  scan_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 2);
  imu_ = nh_.advertise<sensor_msgs::Imu>("imu", 50);
  outcome_ = nh_.advertise<std_msgs::String>("outcome", 1, true);
  cmd_vel_ = nh_.subscribe<geometry_msgs::Twist>(
      "cmd_vel", 1,
      [this](const geometry_msgs::TwistConstPtr& m) {
        if (!std::isfinite(m->linear.x) || !std::isfinite(m->angular.z)) return;
        forward_m_s_ = m->linear.x;
        yaw_rate_rad_s_ = m->angular.z;
        ++commands_;
      },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

void SimNode::publish_clock() {
  rosgraph_msgs::Clock m;
  m.clock = time_of_s(robot_->time_s());
  clock_.publish(m);
}

/// A flight that begins before anybody looks is a flight into the wall.
void SimNode::wait_for_pilot() {
  const ros::WallTime until = ros::WallTime::now() + ros::WallDuration(launch_.pilot_s);
  while (ros::ok() && ros::WallTime::now() < until &&
         (image_.getNumSubscribers() == 0 || cmd_vel_.getNumPublishers() == 0)) {
    publish_clock();
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
}

void SimNode::publish_frame() {
  ++frames_;
  if (launch_.stop_camera_after > 0 && frames_ > launch_.stop_camera_after) return;
  auto picture = std::make_shared<Picture>();
  picture->image = image_of(robot_->look());
  picture->info = camera_info_of(robot_->camera().model());
  picture->image.header.stamp = picture->info.header.stamp = time_of_s(robot_->time_s());
  picture->image.header.frame_id = picture->info.header.frame_id = kOpticalFrame;
  on_the_way_.push_back(std::move(picture));
  if (static_cast<int>(on_the_way_.size()) <= launch_.camera_delay_frames) return;
  camera_info_.publish(on_the_way_.front()->info);
  image_.publish(on_the_way_.front()->image);
  on_the_way_.pop_front();
}

void SimNode::publish_motion() {
  const ros::Time stamp = time_of_s(robot_->time_s());
  nav_msgs::Odometry odometry = odometry_of(robot_->motion());
  odometry.header.stamp = stamp;
  odom_.publish(odometry);
  geometry_msgs::TransformStamped transform = transform_of(robot_->motion());
  transform.header.stamp = stamp;
  transforms_.sendTransform(transform);
  for (const auto& reading : robot_->imu()) imu_.publish(imu_of(reading));
  if (robot_->scan()) scan_.publish(scan_of(*robot_->scan()));
}

/// True when one came for this frame.
bool SimNode::wait_for_command() {
  const std::int64_t before = commands_;
  const ros::WallTime until = ros::WallTime::now() + ros::WallDuration(launch_.wait_s);
  while (ros::ok() && commands_ == before && ros::WallTime::now() < until)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.005));
  return commands_ != before;
}

void SimNode::pace(ros::WallTime& due) {
  due += ros::WallDuration(1.0 / (launch_.robot.camera_rate_hz * launch_.real_time_factor));
  const ros::WallTime now = ros::WallTime::now();
  if (due < now) due = now;  // slower than asked for: the clock is, too
  while (ros::ok() && ros::WallTime::now() < due)
    ros::getGlobalCallbackQueue()->callAvailable(due - ros::WallTime::now());
}

void SimNode::publish_outcome() {
  std_msgs::String m;
  char text[160];
  std::snprintf(text, sizeof text,
                "%s time_s=%.2f distance_m=%.2f clearance_min_m=%.3f commands=%lld waits_in_vain=%lld",
                robot_->outcome().c_str(), robot_->time_s(), robot_->distance_m(), robot_->clearance_min_m(),
                static_cast<long long>(commands_), static_cast<long long>(waits_in_vain_));
  m.data = text;
  outcome_.publish(m);
  ROS_INFO("%s", text);
}

void SimNode::run() {
  geometry_msgs::TransformStamped lens = transform_of(robot_->camera_in_body());
  lens.header.frame_id = "base_link";
  lens.header.stamp = time_of_s(0.0);
  lens.child_frame_id = kOpticalFrame;
  static_transforms_.sendTransform(lens);
  wait_for_pilot();
  ros::WallTime due = ros::WallTime::now();
  while (ros::ok()) {
    publish_clock();
    publish_motion();
    publish_frame();
    if (launch_.lockstep)
      waits_in_vain_ += frames_ > launch_.camera_delay_frames && !wait_for_command();
    else
      pace(due);
    if (!robot_->fly(forward_m_s_, yaw_rate_rad_s_)) break;
  }
  if (robot_->outcome().empty()) return;
  publish_clock();
  publish_motion();
  publish_outcome();
  ros::spin();  // the outcome stays on the air
}

}  // namespace adit_ros1
