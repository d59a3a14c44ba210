#include "camera.hpp"

#include <stdexcept>

#include "adit/io/image_file.hpp"
#include "messages.hpp"
#include "pictures.hpp"

namespace adit_ros1 {

CameraNode::CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh) : nh_(nh), info_(nh, "camera"), transport_(nh) {
  private_nh.param("input", input_, input_);
  private_nh.param("frame_id", frame_id_, frame_id_);
  private_nh.param("rate_hz", rate_hz_, rate_hz_);
  private_nh.param("hfov_deg", hfov_deg_, hfov_deg_);
  private_nh.param("loop", loop_, loop_);
  private_nh.param("preload", preload_, preload_);
  private_nh.param("freeze_after", freeze_after_, freeze_after_);
  std::string url;
  private_nh.param("camera_info_url", url, url);
  if (input_.empty()) throw std::runtime_error("input: not set; name a device, a video or a folder of images");
  if (!(rate_hz_ >= 0.1 && rate_hz_ <= 1000.0)) throw std::runtime_error("rate_hz: not in [0.1, 1000] Hz");
  if (!url.empty() && !info_.loadCameraInfo(url))
    throw std::runtime_error("camera_info_url: '" + url + "' is unreadable");
  open();
  if (preload_)
    for (cv::Mat pixels = next_pixels(); !pixels.empty(); pixels = next_pixels()) loaded_.push_back(pixels);
  publisher_ = transport_.advertiseCamera("camera/image_raw", 1);
  timer_ = nh_.createWallTimer(ros::WallDuration(1.0 / rate_hz_), [this](const ros::WallTimerEvent&) { publish(); });
}

void CameraNode::open() {
  adit::io::SourceOptions options;
  options.images_hz = rate_hz_;
  sources_ = adit::io::open_sources({input_}, options);
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
  if (preload_ && !loaded_.empty()) {
    if (next_ == loaded_.size() && !loop_) return;
    pixels = loaded_[next_++ % loaded_.size()];
    if (loop_) next_ %= loaded_.size();
  } else {
    pixels = next_pixels();
    if (pixels.empty() && loop_) open();
    if (pixels.empty()) return;
  }
  if (freeze_after_ > 0 && ++published_ == freeze_after_) frozen_ = pixels.clone();
  if (!frozen_.empty()) pixels = frozen_;
  const sensor_msgs::ImagePtr image = image_of(pixels);
  sensor_msgs::CameraInfoPtr info(new sensor_msgs::CameraInfo(
      info_.isCalibrated() ? info_.getCameraInfo()
                           : camera_info_of(adit::pinhole(pixels.cols, pixels.rows, hfov_deg_))));
  image->header.stamp = info->header.stamp = stamp;
  image->header.frame_id = info->header.frame_id = frame_id_;
  publisher_.publish(image, info);
}

}  // namespace adit_ros1
