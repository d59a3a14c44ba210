#include "gz_link.hpp"

#include <utility>

#include "adit/io/errors.hpp"
#if __has_include(<gz/transport/Node.hh>)
#include <gz/msgs/boolean.pb.h>
#include <gz/msgs/camera_info.pb.h>
#include <gz/msgs/image.pb.h>
#include <gz/msgs/twist.pb.h>

#include <gz/transport/Node.hh>
namespace transport = gz::transport;
namespace messages = gz::msgs;
#else
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <ignition/transport/Node.hh>
namespace transport = ignition::transport;
namespace messages = ignition::msgs;
#endif

namespace adit::tools {
namespace {

/// ROS's names, which the rest of adit knows; "" for what has none.
const char* encoding_of(messages::PixelFormatType format) {
  switch (format) {
    case messages::L_INT8:
      return "mono8";
    case messages::L_INT16:
      return "mono16";
    case messages::RGB_INT8:
      return "rgb8";
    case messages::RGBA_INT8:
      return "rgba8";
    case messages::BGR_INT8:
      return "bgr8";
    case messages::BGRA_INT8:
      return "bgra8";
    default:
      return "";
  }
}

node::Time_ns stamp_of(const messages::Header& header) {
  return header.stamp().sec() * node::kSecond_ns + header.stamp().nsec();
}

node::ImageMessage borrowed(const messages::Image& image) {
  node::ImageMessage m;
  m.stamp_ns = stamp_of(image.header());
  m.width = image.width();
  m.height = image.height();
  m.encoding = encoding_of(image.pixel_format_type());
  m.step = image.step();
  m.data = reinterpret_cast<const std::uint8_t*>(image.data().data());
  m.size = image.data().size();
  return m;
}

node::CameraInfoMessage camera_info_of(const messages::CameraInfo& info) {
  node::CameraInfoMessage m;
  m.width = info.width();
  m.height = info.height();
  const auto& lens = info.distortion();
  m.distortion.assign(lens.k().begin(), lens.k().end());
  using Lens = messages::CameraInfo::Distortion;
  m.distortion_model = lens.model() == Lens::RATIONAL_POLYNOMIAL ? "rational_polynomial"
                       : lens.model() == Lens::EQUIDISTANT       ? "equidistant"
                                                                 : "plumb_bob";
  for (int i = 0; i < info.intrinsics().k_size() && i < 9; ++i)
    m.matrix[static_cast<std::size_t>(i)] = info.intrinsics().k(i);
  return m;
}

void subscribed(bool is_good, const std::string& topic) {
  if (!is_good) throw io::InputError(topic + ": Gazebo's transport refuses this topic; names look like /camera");
}

}  // namespace

std::string camera_info_beside(const std::string& image_topic) {
  const auto slash = image_topic.rfind('/');
  return (slash == std::string::npos ? std::string("/") : image_topic.substr(0, slash + 1)) + "camera_info";
}

struct GzLink::Parts {
  OnImage on_image;
  OnCameraInfo on_camera_info;
  transport::Node::Publisher command, enable;
  transport::Node node;  ///< last: it ends before what it calls
};

GzLink::GzLink(const GzTopics& topics, OnImage on_image, OnCameraInfo on_camera_info)
    : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.on_image = std::move(on_image);
  p.on_camera_info = std::move(on_camera_info);
  p.command = p.node.Advertise<messages::Twist>(topics.command);
  subscribed(static_cast<bool>(p.command), topics.command);
  if (!topics.enable.empty()) p.enable = p.node.Advertise<messages::Boolean>(topics.enable);
  const std::string info = topics.camera_info.empty() ? camera_info_beside(topics.image) : topics.camera_info;
  std::function<void(const messages::CameraInfo&)> take_info = [&p](const messages::CameraInfo& m) {
    p.on_camera_info(camera_info_of(m));
  };
  std::function<void(const messages::Image&)> take_image = [&p](const messages::Image& m) { p.on_image(borrowed(m)); };
  subscribed(p.node.Subscribe(info, take_info), info);
  subscribed(p.node.Subscribe(topics.image, take_image), topics.image);
}

GzLink::~GzLink() = default;

void GzLink::send(double forward_m_s, double yaw_rate_rad_s) {
  messages::Twist twist;
  twist.mutable_linear()->set_x(forward_m_s);
  twist.mutable_angular()->set_z(yaw_rate_rad_s);
  parts_->command.Publish(twist);
}

void GzLink::enable() {
  if (!parts_->enable) return;
  messages::Boolean on;
  on.set_data(true);
  parts_->enable.Publish(on);
}

}  // namespace adit::tools
