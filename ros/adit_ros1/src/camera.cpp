#include "camera.hpp"

#include <stdexcept>

#include "adit/io/image_file.hpp"
#include "launch_parameters.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "pictures.hpp"

namespace adit_ros1 {

CameraNode::CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : nh_(nh), launch_(launch_parameters<adit::node::CameraLaunch>(private_nh)), info_(nh, "camera"), transport_(nh) {
  if (launch_.input.empty()) throw std::runtime_error("input: not set; name a device, a video or a folder of images");
  if (const std::string& url = launch_.camera_info_url; !url.empty() && !info_.loadCameraInfo(url))
    throw std::runtime_error("camera_info_url: '" + url + "' is unreadable");
  const bool is_device = launch_.input.rfind("/dev/", 0) == 0;
  if (is_device && launch_.preload)
    throw std::runtime_error("preload: " + launch_.input + " is a device and has no end");
  open();
  if (launch_.preload)
    for (cv::Mat pixels = next_pixels(); !pixels.empty(); pixels = next_pixels()) loaded_.push_back(pixels);
  publisher_ = transport_.advertiseCamera(name_beside(private_nh, "camera/image_raw"), 1);
  if (is_device)
    reader_ = std::thread([this] { follow_device(); });
  else
    timer_ =
        nh_.createWallTimer(ros::WallDuration(1.0 / launch_.rate_hz), [this](const ros::WallTimerEvent&) { play(); });
}

CameraNode::~CameraNode() {
  has_ended_ = true;
  if (reader_.joinable()) reader_.join();
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
      if (const std::string fault = sources_.front()->fault(); !fault.empty()) ROS_ERROR("%s", fault.c_str());
      sources_.erase(sources_.begin());
      continue;
    }
    adit::io::load_pixels(*frame);
    if (!frame->fault.empty()) ROS_WARN("%s", frame->fault.c_str());
    if (!frame->pixels.empty()) return frame->pixels;
  }
  return {};
}

// A device keeps its own time. A timer that asks for frames would find them old, as many periods as the driver has
// buffers, and would stamp them before they were there.
void CameraNode::follow_device() {
  while (!has_ended_) {
    const cv::Mat pixels = next_pixels();  // waits for it
    const ros::Time stamp = ros::Time::now();
    if (!pixels.empty()) {
      publish(pixels, stamp);
      continue;
    }
    ros::WallDuration(1.0).sleep();
    try {
      open();
      ROS_INFO("%s: there again", launch_.input.c_str());
    } catch (const std::exception& e) {
      ROS_WARN_THROTTLE(10.0, "%s", e.what());
    }
  }
}

void CameraNode::play() {
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
  publish(pixels, stamp);
}

void CameraNode::publish(cv::Mat pixels, const ros::Time& stamp) {
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
