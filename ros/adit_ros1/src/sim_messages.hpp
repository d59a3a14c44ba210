// What the simulated robot's sensors say, as messages.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>

#include "adit/node/simulated_robot.hpp"

namespace adit_ros1 {

[[nodiscard]] ros::Time time_of_s(double time_s);
[[nodiscard]] sensor_msgs::Image image_of(const adit::ImageView& view);
[[nodiscard]] sensor_msgs::CameraInfo camera_info_of(const adit::CameraModel& model);
/// Twist in the body frame, as nav_msgs/Odometry wants it.
[[nodiscard]] nav_msgs::Odometry odometry_of(const adit::node::RobotMotion& motion);
[[nodiscard]] geometry_msgs::TransformStamped transform_of(const adit::node::RobotMotion& motion);
[[nodiscard]] geometry_msgs::TransformStamped transform_of(const adit::node::Placement& placement);
[[nodiscard]] sensor_msgs::Imu imu_of(const adit::node::ImuReading& reading);
[[nodiscard]] sensor_msgs::LaserScan scan_of(const adit::node::ScanReading& scan);

}  // namespace adit_ros1
