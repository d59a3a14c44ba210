// The perception component: topics around adit::node::Perception. The same topics and names as adit_ros1's.
#include "adit_ros2/msg/open_space.hpp"

#include <algorithm>
#include <chrono>
#include <diagnostic_updater/diagnostic_updater.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <image_transport/image_transport.hpp>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/imu.hpp>

#include "adit/io/topic_pictures.hpp"
#include "adit/node/direction.hpp"
#include "adit/node/launch_config.hpp"
#include "adit/node/perception.hpp"
#include "parameters.hpp"

namespace adit_ros2 {
namespace {

using adit::node::Time_ns;
using sensor_msgs::msg::Image;

Time_ns time_of(const builtin_interfaces::msg::Time& t) { return rclcpp::Time(t).nanoseconds(); }
builtin_interfaces::msg::Time time_of(Time_ns ns) { return rclcpp::Time(ns); }

adit::node::ImageMessage borrowed(const Image& m) {
  return {time_of(m.header.stamp), m.header.frame_id, m.width, m.height, m.encoding, m.is_bigendian != 0, m.step,
          m.data.data(),           m.data.size()};
}

adit::node::CameraInfoMessage camera_info_of(const sensor_msgs::msg::CameraInfo& m) {
  adit::node::CameraInfoMessage info;
  info.width = m.width;
  info.height = m.height;
  info.distortion_model = m.distortion_model;
  info.distortion = m.d;
  std::copy(m.k.begin(), m.k.end(), info.matrix.begin());
  info.binning_x = m.binning_x;
  info.binning_y = m.binning_y;
  info.roi_x_offset = m.roi.x_offset;
  info.roi_y_offset = m.roi.y_offset;
  info.roi_width = m.roi.width;
  info.roi_height = m.roi.height;
  return info;
}

msg::Opening opening_of(const adit::Opening& o) {
  msg::Opening m;
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

msg::OpenSpace open_space_of(const adit::node::Sighting& s, const std::string& frame_id) {
  const adit::OpenSpace& o = s.open_space;
  msg::OpenSpace m;
  m.header.stamp = time_of(s.stamp_ns);
  m.header.frame_id = frame_id;
  m.status = static_cast<std::uint8_t>(o.status);
  m.status_text = to_string(o.status);
  m.rule = to_string(o.rule);
  m.manoeuvre = static_cast<std::uint8_t>(s.manoeuvre);
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

Image image_of(const cv::Mat& pixels, Time_ns stamp_ns, const std::string& frame_id) {
  Image m;
  m.header.stamp = time_of(stamp_ns);
  m.header.frame_id = frame_id;
  m.width = static_cast<std::uint32_t>(pixels.cols);
  m.height = static_cast<std::uint32_t>(pixels.rows);
  m.encoding = pixels.channels() == 1 ? "mono8" : "bgr8";
  m.step = static_cast<std::uint32_t>(static_cast<std::size_t>(pixels.cols) * pixels.elemSize());
  m.data.assign(pixels.datastart, pixels.dataend);
  return m;
}

}  // namespace

class OpenSpaceNode : public rclcpp::Node {
 public:
  explicit OpenSpaceNode(const rclcpp::NodeOptions& options)
      : Node("open_space", options),
        updater_(this),
        body_frame_(declare_parameter("body_frame", adit::node::PerceptionLaunch().body_frame)) {
    handle_ = serve(*this, {[this] { return perception_.parameters(); },
                            [this](const std::string& name, const adit::node::ParameterValue& value) {
                              return perception_.set(name, value);
                            },
                            [this] { perception_.apply(); }});
    const auto reliable = rclcpp::QoS(1);
    open_space_ = create_publisher<msg::OpenSpace>("open_space", reliable);
    heading_ = create_publisher<geometry_msgs::msg::TwistStamped>("heading", reliable);
    direction_ = create_publisher<geometry_msgs::msg::PoseStamped>("direction", reliable);
    scattering_depth_ = create_publisher<Image>("scattering_depth", reliable);
    overlay_ = create_publisher<Image>("overlay", reliable);
    camera_info_ = create_subscription<sensor_msgs::msg::CameraInfo>(
        "camera_info", rclcpp::SensorDataQoS(),
        [this](const sensor_msgs::msg::CameraInfo& m) { perception_.take(camera_info_of(m)); });
    imu_ = create_subscription<sensor_msgs::msg::Imu>(
        "imu", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::Imu& m) {
          perception_.take_yaw_rate(m.angular_velocity.z, time_of(m.header.stamp));
        });
    image_ = image_transport::create_subscription(
        this, "image", [this](const Image::ConstSharedPtr& m) { take(*m); },
        declare_parameter("image_transport", adit::node::PerceptionLaunch().image_transport),
        rclcpp::SensorDataQoS().get_rmw_qos_profile());
    updater_.setHardwareID("none");
    updater_.add("open space", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
      const auto d = perception_.diagnosis(now().nanoseconds());
      status.summary(static_cast<std::uint8_t>(d.level), d.message);
      for (const auto& [key, value] : d.values) status.add(key, value);
    });
  }

 private:
  void take(const Image& image) {
    const auto message = borrowed(image);
    const auto answer = perception_.take(message, now().nanoseconds());
    if (!answer.fault.empty()) RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000, "%s", answer.fault.c_str());
    if (!answer.sighting) return;
    const auto& s = *answer.sighting;
    open_space_->publish(open_space_of(s, image.header.frame_id));
    geometry_msgs::msg::TwistStamped heading;
    heading.header.stamp = time_of(s.stamp_ns);
    heading.header.frame_id = body_frame_;
    heading.twist.linear.x = s.forward_m_s;
    heading.twist.angular.z = s.heading.yaw_rate_rad_s;
    heading_->publish(heading);
    perception_.sent(s.stamp_ns, now().nanoseconds());
    publish_for_people(message, s, image.header.frame_id);
  }

  /// Made only while somebody listens.
  void publish_for_people(const adit::node::ImageMessage& message, const adit::node::Sighting& s,
                          const std::string& frame_id) {
    if (s.open_space.found() && direction_->get_subscription_count() > 0) {
      const auto q = adit::node::arrow_of(s.open_space.bearing);
      geometry_msgs::msg::PoseStamped arrow;
      arrow.header.stamp = time_of(s.stamp_ns);
      arrow.header.frame_id = frame_id;
      arrow.pose.orientation.x = q.x;
      arrow.pose.orientation.y = q.y;
      arrow.pose.orientation.z = q.z;
      arrow.pose.orientation.w = q.w;
      direction_->publish(arrow);
    }
    const adit::FinderConfig& finder = perception_.finder_config();
    if (overlay_->get_subscription_count() > 0)
      overlay_->publish(
          image_of(adit::io::overlay_of(view_of(message).view, s.open_space, s.heading, finder.grey16_depth_bits),
                   s.stamp_ns, frame_id));
    if (scattering_depth_->get_subscription_count() == 0) return;
    if (const auto stages = perception_.explain(message))
      scattering_depth_->publish(image_of(adit::io::scattering_depth_levels(*stages, finder), s.stamp_ns, frame_id));
  }

  adit::node::Perception perception_;
  diagnostic_updater::Updater updater_;
  std::string body_frame_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
  rclcpp::Publisher<msg::OpenSpace>::SharedPtr open_space_;
  rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr heading_;
  rclcpp::Publisher<geometry_msgs::msg::PoseStamped>::SharedPtr direction_;
  rclcpp::Publisher<Image>::SharedPtr scattering_depth_, overlay_;
  rclcpp::Subscription<sensor_msgs::msg::CameraInfo>::SharedPtr camera_info_;
  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imu_;
  image_transport::Subscriber image_;
};

}  // namespace adit_ros2

RCLCPP_COMPONENTS_REGISTER_NODE(adit_ros2::OpenSpaceNode)
