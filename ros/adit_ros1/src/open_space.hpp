// The perception node: topics around adit::node::Perception.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Imu.h>

#include <memory>
#include <optional>
#include <string>

#include "adit/node/perception.hpp"
#include "field_server.hpp"
#include "launch_parameters.hpp"
#include "messages.hpp"

namespace adit_ros1 {

/// All callbacks run on one thread at a time, as the callback queue of a node or of a nodelet does by itself.
class OpenSpaceNode {
 public:
  /// @throws std::invalid_argument naming the parameter, the value and the range.
  OpenSpaceNode(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& name);

 private:
  void subscribe();
  void take_image(const sensor_msgs::ImageConstPtr& image);
  void take_compressed(const sensor_msgs::CompressedImageConstPtr& image);
  void judge(const adit::node::ImageMessage& message, const std::string& frame_id);
  void publish(const adit::node::Sighting& sighting, const std::string& frame_id);
  void publish_pictures(const adit::node::ImageMessage& message, const adit::node::Sighting& sighting,
                        const std::string& frame_id);
  FieldServer::Fields fields();

  ros::NodeHandle nh_, private_nh_;
  adit::node::PerceptionLaunch launch_;
  adit::node::Perception perception_;
  FieldServer parameters_;
  diagnostic_updater::Updater updater_;
  image_transport::ImageTransport transport_;
  image_transport::Subscriber image_;
  ros::Subscriber compressed_, camera_info_, imu_;
  ros::Publisher open_space_, heading_, direction_, scattering_depth_, overlay_;
  ros::WallTimer report_;
  std::int64_t overlays_made_ = 0, scattering_depths_made_ = 0, arrows_made_ = 0;  ///< for those who listened
};

}  // namespace adit_ros1
