// The simulator as a robot: camera, camera_info, odom, tf, scan, imu and /clock out; cmd_vel in.
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <deque>
#include <memory>
#include <string>

#include "adit/node/launch_config.hpp"
#include "adit/node/simulated_robot.hpp"

namespace adit_ros1 {

class SimNode {
 public:
  /// @throws std::invalid_argument
  SimNode(ros::NodeHandle nh, ros::NodeHandle private_nh);
  /// Until the flight is over or ROS shuts down.
  void run();

 private:
  void wait_for_pilot();
  void publish_clock();
  void publish_frame();
  void publish_motion();
  void publish_outcome();
  void pace(ros::WallTime& due);
  [[nodiscard]] bool wait_for_command();

  ros::NodeHandle nh_;
  adit::node::SimLaunch launch_;
  std::unique_ptr<adit::node::SimulatedRobot> robot_;
  double forward_m_s_ = 0.0, yaw_rate_rad_s_ = 0.0;
  std::int64_t commands_ = 0, frames_ = 0, waits_in_vain_ = 0;

  struct Picture;
  std::deque<std::shared_ptr<Picture>> on_the_way_;
  ros::Publisher clock_, image_, camera_info_, odom_, scan_, imu_, outcome_;
  ros::Subscriber cmd_vel_;
  tf2_ros::TransformBroadcaster transforms_;
  tf2_ros::StaticTransformBroadcaster static_transforms_;
};

}  // namespace adit_ros1
