#include "messages.hpp"

#include <algorithm>

#include "adit/node/direction.hpp"
#include "adit/node/message_fields.hpp"

namespace adit_ros1 {

using adit::node::Sighting;

ros::Time time_of(adit::node::Time_ns time_ns) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(std::max<adit::node::Time_ns>(time_ns, 0)));
  return time;
}

adit::node::ImageMessage borrowed(const sensor_msgs::Image& image) {
  return {time_of(image.header.stamp),
          image.header.frame_id,
          image.width,
          image.height,
          image.encoding,
          image.is_bigendian != 0,
          image.step,
          image.data.data(),
          image.data.size()};
}

adit::node::CameraInfoMessage camera_info_of(const sensor_msgs::CameraInfo& info) {
  adit::node::CameraInfoMessage made;
  made.width = info.width;
  made.height = info.height;
  made.distortion_model = info.distortion_model;
  made.distortion = info.D;
  std::copy(info.K.begin(), info.K.end(), made.matrix.begin());
  made.binning_x = info.binning_x;
  made.binning_y = info.binning_y;
  made.roi_x_offset = info.roi.x_offset;
  made.roi_y_offset = info.roi.y_offset;
  made.roi_width = info.roi.width;
  made.roi_height = info.roi.height;
  return made;
}

sensor_msgs::CameraInfo camera_info_of(const adit::CameraModel& model) {
  sensor_msgs::CameraInfo info;
  adit::node::fill_camera_info(info, model);
  return info;
}

namespace {

adit_ros1::Opening opening_of(const adit::Opening& o) {
  adit_ros1::Opening m;
  m.azimuth = static_cast<float>(o.bearing.azimuth_rad);
  m.elevation = static_cast<float>(o.bearing.elevation_rad);
  m.half_width = static_cast<float>(o.half_width_rad);
  m.half_height = static_cast<float>(o.half_height_rad);
  m.u = static_cast<float>(o.centroid_px.u_px);
  m.v = static_cast<float>(o.centroid_px.v_px);
  m.area_fraction = static_cast<float>(o.area_fraction);
  m.score = static_cast<float>(o.score);
  m.confidence = static_cast<float>(o.confidence);
  m.touches_border = o.touches_border;
  return m;
}

}  // namespace

adit_ros1::OpenSpace open_space_of(const Sighting& sighting, const std::string& frame_id) {
  const adit::OpenSpace& o = sighting.open_space;
  adit_ros1::OpenSpace m;
  m.header.stamp = time_of(sighting.stamp_ns);
  m.header.frame_id = frame_id;
  m.status = static_cast<std::uint8_t>(o.status);
  m.status_text = std::string(to_string(o.status));
  m.rule = std::string(to_string(o.rule));
  m.manoeuvre = static_cast<std::uint8_t>(sighting.manoeuvre);
  m.dust = o.flags.dust;
  m.glare = o.flags.glare;
  m.blocked_lens = o.flags.blocked_lens;
  m.too_dark = o.flags.too_dark;
  m.too_bright = o.flags.too_bright;
  m.dirty_lens = o.flags.dirty_lens;
  m.veil_fraction = static_cast<float>(o.veil_fraction);
  m.find_ms = static_cast<float>(static_cast<double>(o.total_ns) * 1e-6);
  if (!o.found()) return m;
  m.confidence = static_cast<float>(o.confidence);
  m.u = static_cast<float>(o.centroid_px.u_px);
  m.v = static_cast<float>(o.centroid_px.v_px);
  m.sx = o.point.sx;
  m.sy = o.point.sy;
  m.azimuth = o.bearing.azimuth_rad;
  m.elevation = o.bearing.elevation_rad;
  m.area_fraction = static_cast<float>(o.area_fraction);
  for (int i = 0; i < o.opening_count; ++i) m.openings.push_back(opening_of(o.openings[static_cast<std::size_t>(i)]));
  return m;
}

geometry_msgs::TwistStamped heading_of(const Sighting& sighting, const std::string& frame_id) {
  geometry_msgs::TwistStamped m;
  m.header.stamp = time_of(sighting.stamp_ns);
  m.header.frame_id = frame_id;
  m.twist.linear.x = sighting.forward_m_s;
  m.twist.angular.z = sighting.heading.yaw_rate_rad_s;
  return m;
}

geometry_msgs::PoseStamped direction_of(const Sighting& sighting, const std::string& frame_id) {
  const adit::node::Quaternion q = adit::node::arrow_of(sighting.open_space.bearing);
  geometry_msgs::PoseStamped m;
  m.header.stamp = time_of(sighting.stamp_ns);
  m.header.frame_id = frame_id;
  m.pose.orientation.x = q.x;
  m.pose.orientation.y = q.y;
  m.pose.orientation.z = q.z;
  m.pose.orientation.w = q.w;
  return m;
}

geometry_msgs::Twist twist_of(const adit::node::VelocityCommand& command) {
  geometry_msgs::Twist m;
  m.linear.x = command.forward_m_s;
  m.angular.z = command.yaw_rate_rad_s;
  return m;
}

void fill(diagnostic_updater::DiagnosticStatusWrapper& status, const adit::node::Diagnosis& diagnosis) {
  status.summary(static_cast<std::uint8_t>(diagnosis.level), diagnosis.message);
  for (const auto& [key, value] : diagnosis.values) status.add(key, value);
}

}  // namespace adit_ros1
