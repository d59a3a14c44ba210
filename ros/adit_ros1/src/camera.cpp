#include "camera.hpp"

#include <stdexcept>

#include "adit/io/image_file.hpp"
#include "launch_parameters.hpp"
#include "messages.hpp"
#include "pictures.hpp"

namespace adit_ros1 {

CameraNode::CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : nh_(nh), launch_(launch_parameters<adit::node::CameraLaunch>(private_nh)), info_(nh, "camera"), transport_(nh) {
  if (launch_.input.empty()) throw std::runtime_error("input: not set; name a device, a video or a folder of images");
  if (const std::string& url = launch_.camera_info_url; !url.empty() && !info_.loadCameraInfo(url))
    throw std::runtime_error("camera_info_url: '" + url + "' is unreadable");
  open();
  if (launch_.preload)
    for (cv::Mat pixels = next_pixels(); !pixels.empty(); pixels = next_pixels()) loaded_.push_back(pixels);
  publisher_ = transport_.advertiseCamera("camera/image_raw", 1);
  timer_ =
      nh_.createWallTimer(ros::WallDuration(1.0 / launch_.rate_hz), [this](const ros::WallTimerEvent&) { publish(); });
}

void CameraNode::open() {
  adit::io::SourceOptions options;
  options.images_hz = launch_.rate_hz;
  sources_ = adit::io::open_sources({launch_.input}, options);
}

cv::Mat CameraNode::next_pixels() {
  while (!sources_.empty()) {
    auto frame = sources_.front()->next();
    if (!frame) {
      sources_.erase(sources_.begin());
      continue;
    }
    adit::io::load_pixels(*frame);
    if (!frame->fault.empty()) ROS_WARN("%s", frame->fault.c_str());
    if (!frame->pixels.empty()) return frame->pixels;
  }
  return {};
}

void CameraNode::publish() {
  const ros::Time stamp = ros::Time::now();
  cv::Mat pixels;
  if (launch_.preload && !loaded_.empty()) {
    if (next_ == loaded_.size() && !launch_.loop) return;
    pixels = loaded_[next_++ % loaded_.size()];
    if (launch_.loop) next_ %= loaded_.size();
  } else {
    pixels = next_pixels();
    if (pixels.empty() && launch_.loop) open();
    if (pixels.empty()) return;
  }
  if (launch_.freeze_after > 0 && ++published_ == launch_.freeze_after) frozen_ = pixels.clone();
  if (!frozen_.empty()) pixels = frozen_;
  const sensor_msgs::ImagePtr image = image_of(pixels);
  sensor_msgs::CameraInfoPtr info(new sensor_msgs::CameraInfo(
      info_.isCalibrated() ? info_.getCameraInfo()
                           : camera_info_of(adit::pinhole(pixels.cols, pixels.rows, launch_.hfov_deg))));
  image->header.stamp = info->header.stamp = stamp;
  image->header.frame_id = info->header.frame_id = launch_.frame_id;
  publisher_.publish(image, info);
}

}  // namespace adit_ros1
