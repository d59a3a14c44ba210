#include "sim_messages.hpp"

#include <cstring>

namespace adit_ros1 {
namespace {

template <class Message>
void fill(Message& m, const std::array<double, 3>& v) {
  m.x = v[0];
  m.y = v[1];
  m.z = v[2];
}

geometry_msgs::Quaternion quaternion_of(const std::array<double, 4>& q) {
  geometry_msgs::Quaternion m;
  m.x = q[0];
  m.y = q[1];
  m.z = q[2];
  m.w = q[3];
  return m;
}

}  // namespace

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
  info.width = static_cast<std::uint32_t>(model.width);
  info.height = static_cast<std::uint32_t>(model.height);
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  if (model.distortion_model == adit::DistortionModel::kPlumbBob)
    info.D.assign(model.distortion.begin(), model.distortion.begin() + 5);
  const double fx = model.focal_length_x_px, fy = model.focal_length_y_px;
  const double ox = model.principal_point_x_px, oy = model.principal_point_y_px;
  info.K = {fx, 0, ox, 0, fy, oy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {fx, 0, ox, 0, 0, fy, oy, 0, 0, 0, 1, 0};
  return info;
}

nav_msgs::Odometry odometry_of(const adit::node::RobotMotion& motion) {
  nav_msgs::Odometry m;
  m.header.frame_id = "odom";
  m.child_frame_id = "base_link";
  fill(m.pose.pose.position, motion.in_world.place_m);
  m.pose.pose.orientation = quaternion_of(motion.in_world.rotation);
  fill(m.twist.twist.linear, motion.velocity_m_s);
  fill(m.twist.twist.angular, motion.angular_rate_rad_s);
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
  fill(m.transform.translation, placement.place_m);
  m.transform.rotation = quaternion_of(placement.rotation);
  return m;
}

sensor_msgs::Imu imu_of(const adit::node::ImuReading& reading) {
  sensor_msgs::Imu m;
  m.header.stamp = time_of_s(reading.stamp_s);
  m.header.frame_id = "base_link";
  m.orientation_covariance[0] = -1.0;  // not given
  fill(m.angular_velocity, reading.angular_rate_rad_s);
  fill(m.linear_acceleration, reading.specific_force_m_s2);
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
