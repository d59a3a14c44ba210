#include "sim_messages.hpp"

#include <cstring>

#include "adit/node/message_fields.hpp"

namespace adit_ros1 {

using adit::node::fill_quaternion;
using adit::node::fill_vector;
ros::Time time_of_s(double time_s) {
  // ROS takes 0 for "no time yet": the simulation begins at 1 s.
  return ros::Time(1.0 + time_s);
}

sensor_msgs::Image image_of(const adit::ImageView& view) {
  sensor_msgs::Image m;
  m.width = static_cast<std::uint32_t>(view.width);
  m.height = static_cast<std::uint32_t>(view.height);
  m.encoding = view.format == adit::PixelFormat::kGrey8 ? "mono8" : "bgr8";
  m.step = m.width * static_cast<std::uint32_t>(bytes_per_pixel(view.format));
  m.data.resize(std::size_t{m.step} * m.height);
  for (int v = 0; v < view.height; ++v)
    std::memcpy(m.data.data() + std::size_t{m.step} * static_cast<std::size_t>(v), view.row(v), m.step);
  return m;
}

sensor_msgs::CameraInfo camera_info_of(const adit::CameraModel& model) {
  sensor_msgs::CameraInfo info;
  adit::node::fill_camera_info(info, model);
  return info;
}

nav_msgs::Odometry odometry_of(const adit::node::RobotMotion& motion) {
  nav_msgs::Odometry m;
  m.header.frame_id = "odom";
  m.child_frame_id = "base_link";
  fill_vector(m.pose.pose.position, motion.in_world.place_m);
  fill_quaternion(m.pose.pose.orientation, motion.in_world.rotation);
  fill_vector(m.twist.twist.linear, motion.velocity_m_s);
  fill_vector(m.twist.twist.angular, motion.angular_rate_rad_s);
  return m;
}

geometry_msgs::TransformStamped transform_of(const adit::node::RobotMotion& motion) {
  geometry_msgs::TransformStamped m = transform_of(motion.in_world);
  m.header.frame_id = "odom";
  m.child_frame_id = "base_link";
  return m;
}

geometry_msgs::TransformStamped transform_of(const adit::node::Placement& placement) {
  geometry_msgs::TransformStamped m;
  fill_vector(m.transform.translation, placement.place_m);
  fill_quaternion(m.transform.rotation, placement.rotation);
  return m;
}

sensor_msgs::Imu imu_of(const adit::node::ImuReading& reading) {
  sensor_msgs::Imu m;
  m.header.stamp = time_of_s(reading.stamp_s);
  m.header.frame_id = "base_link";
  m.orientation_covariance[0] = -1.0;  // not given
  fill_vector(m.angular_velocity, reading.angular_rate_rad_s);
  fill_vector(m.linear_acceleration, reading.specific_force_m_s2);
  return m;
}

sensor_msgs::LaserScan scan_of(const adit::node::ScanReading& scan) {
  sensor_msgs::LaserScan m;
  m.header.stamp = time_of_s(scan.stamp_s);
  m.header.frame_id = "base_link";  // it sits at the body's centre
  m.angle_min = static_cast<float>(scan.angle_min_rad);
  m.angle_increment = static_cast<float>(scan.angle_step_rad);
  m.angle_max = m.angle_min + m.angle_increment * static_cast<float>(scan.ranges_m.size() - 1);
  m.scan_time = static_cast<float>(scan.interval_s);
  m.range_min = static_cast<float>(scan.range_min_m);
  m.range_max = static_cast<float>(scan.range_max_m);
  m.ranges = scan.ranges_m;
  return m;
}

}  // namespace adit_ros1
