// Messages to adit's structs and back: nothing else.
#pragma once

#include <adit_ros1/OpenSpace.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "adit/node/camera_info.hpp"
#include "adit/node/diagnosis.hpp"
#include "adit/node/image_message.hpp"
#include "adit/node/perception.hpp"
#include "adit/node/velocity.hpp"

namespace adit_ros1 {

[[nodiscard]] inline adit::node::Time_ns time_of(const ros::Time& time) {
  return static_cast<adit::node::Time_ns>(time.toNSec());
}
[[nodiscard]] ros::Time time_of(adit::node::Time_ns time_ns);

/// Borrows the pixels: the message must outlive what is returned.
[[nodiscard]] adit::node::ImageMessage borrowed(const sensor_msgs::Image& image);
[[nodiscard]] adit::node::CameraInfoMessage camera_info_of(const sensor_msgs::CameraInfo& info);
[[nodiscard]] sensor_msgs::CameraInfo camera_info_of(const adit::CameraModel& model);

[[nodiscard]] adit_ros1::OpenSpace open_space_of(const adit::node::Sighting& sighting, const std::string& frame_id);
/// REP 103: body frame, x forward, yaw rate positive to the left.
[[nodiscard]] geometry_msgs::TwistStamped heading_of(const adit::node::Sighting& sighting, const std::string& frame_id);
/// An arrow from the lens, in the optical frame.
[[nodiscard]] geometry_msgs::PoseStamped direction_of(const adit::node::Sighting& sighting,
                                                      const std::string& frame_id);
[[nodiscard]] geometry_msgs::Twist twist_of(const adit::node::VelocityCommand& command);

void fill(diagnostic_updater::DiagnosticStatusWrapper& status, const adit::node::Diagnosis& diagnosis);

}  // namespace adit_ros1
