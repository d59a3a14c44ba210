// Gazebo's topics as plain calls. The one place that knows which transport it is: ignition-transport 11 (Fortress) or
// gz-transport 12 to 14 (Garden, Harmonic, Ionic).
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adit/node/camera_info.hpp"
#include "adit/node/image_message.hpp"

namespace adit::tools {

struct GzTopics {
  std::string image = "/camera";
  std::string camera_info;  ///< "": camera_info beside the image, as Gazebo's sensors have it
  std::string command = "/cmd_vel";
  std::string enable;  ///< a Boolean that starts the vehicle's controller; "": none
};

/// "/front/image" -> "/front/camera_info"
[[nodiscard]] std::string camera_info_beside(const std::string& image_topic);

class GzLink {
 public:
  /// Both are called on the transport's own threads. The image's pixels are borrowed for the call.
  using OnImage = std::function<void(const node::ImageMessage&)>;
  using OnCameraInfo = std::function<void(const node::CameraInfoMessage&)>;

  /// @throws io::InputError for a topic that the transport refuses.
  GzLink(const GzTopics& topics, OnImage on_image, OnCameraInfo on_camera_info);
  ~GzLink();  ///< no call comes after it

  /// Twist in the body frame: x forward, yaw positive to the left.
  void send(double forward_m_s, double yaw_rate_rad_s);
  void enable();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace adit::tools
