// The camera node: whatever adit can read (a device, a video, a folder of images) as a camera driver.
#pragma once

#include <camera_info_manager/camera_info_manager.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

#include <atomic>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <thread>
#include <vector>

#include "adit/io/frame_source.hpp"
#include "adit/node/launch_config.hpp"

namespace adit_ros1 {

class CameraNode {
 public:
  /// @throws std::runtime_error naming the input or the parameter and what to do.
  CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh);
  ~CameraNode();
  CameraNode(const CameraNode&) = delete;
  CameraNode& operator=(const CameraNode&) = delete;

 private:
  [[nodiscard]] cv::Mat next_pixels();
  void open();
  /// A recording's next frame, when its time has come.
  void play();
  /// A device's frames as they come, until the end; a device that is gone is asked for again each second.
  void follow_device();
  void publish(cv::Mat pixels, const ros::Time& stamp);

  ros::NodeHandle nh_;
  adit::node::CameraLaunch launch_;
  std::vector<std::unique_ptr<adit::io::FrameSource>> sources_;
  std::vector<cv::Mat> loaded_;  ///< with preload
  std::size_t next_ = 0;
  std::int64_t published_ = 0;
  cv::Mat frozen_;
  camera_info_manager::CameraInfoManager info_;
  image_transport::ImageTransport transport_;
  image_transport::CameraPublisher publisher_;
  ros::WallTimer timer_;
  std::atomic<bool> has_ended_{false};
  std::thread reader_;
};

}  // namespace adit_ros1
