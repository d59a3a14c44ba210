#include "bag_messages.hpp"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/image_file.hpp"
#include "adit/node/image_message.hpp"

namespace adit::io {
namespace {

constexpr const char* kImage = "sensor_msgs/Image";
constexpr const char* kCompressed = "sensor_msgs/CompressedImage";

/// A copy in OpenCV's order of colours, as image files are read.
cv::Mat copied(const ImageView& view) {
  const cv::Mat pixels = mat_of(view);
  return pixels.data == view.data ? pixels.clone() : pixels;
}

void take(const sensor_msgs::Image& m, BagImage& image) {
  const node::ImageReading reading = view_of(node::ImageMessage{
      0, "", m.width, m.height, m.encoding, m.is_bigendian != 0, m.step, m.data.data(), m.data.size()});
  image.fault = reading.fault;
  if (reading.view.data != nullptr) image.pixels = copied(reading.view);
}

void take(const sensor_msgs::CompressedImage& m, BagImage& image) {
  try {
    if (!m.data.empty()) image.pixels = cv::imdecode(m.data, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.pixels.release();
  }
  if (image.pixels.empty()) image.fault = "the bytes are no picture (format '" + m.format + "')";
}

template <class Message>
BagImage read(const rosbag::MessageInstance& instance) {
  BagImage image;
  image.stamp_ns = static_cast<std::int64_t>(instance.getTime().toNSec());
  const auto message = instance.instantiate<Message>();
  if (!message) {
    image.fault = "the message is not of its topic's type";
    return image;
  }
  if (!message->header.stamp.isZero()) image.stamp_ns = static_cast<std::int64_t>(message->header.stamp.toNSec());
  take(*message, image);
  return image;
}

}  // namespace

bool is_image_type(const std::string& type) { return type == kImage || type == kCompressed; }

BagImage image_of(const rosbag::MessageInstance& message) {
  return message.getDataType() == kCompressed ? read<sensor_msgs::CompressedImage>(message)
                                              : read<sensor_msgs::Image>(message);
}

std::optional<node::CameraInfoMessage> camera_info_of(const rosbag::MessageInstance& instance) {
  const auto m = instance.instantiate<sensor_msgs::CameraInfo>();
  if (!m) return std::nullopt;
  node::CameraInfoMessage info;
  info.width = m->width;
  info.height = m->height;
  info.distortion_model = m->distortion_model;
  info.distortion = m->D;
  std::copy(m->K.begin(), m->K.end(), info.matrix.begin());
  info.binning_x = m->binning_x;
  info.binning_y = m->binning_y;
  info.roi_x_offset = m->roi.x_offset;
  info.roi_y_offset = m->roi.y_offset;
  info.roi_width = m->roi.width;
  info.roi_height = m->roi.height;
  return info;
}

}  // namespace adit::io
