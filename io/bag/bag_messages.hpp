// Messages of ROS 1 as frames and calibrations.
#pragma once

#include <rosbag/message_instance.h>

#include <optional>
#include <string>

#include "adit/io/frame_source.hpp"
#include "adit/node/camera_info.hpp"

namespace adit::io {

[[nodiscard]] bool is_image_type(const std::string& type);

/// Pixels and stamp in nanoseconds; `fault` without a file name when the message cannot be used.
struct BagImage {
  cv::Mat pixels;
  std::int64_t stamp_ns = 0;  ///< of the header; of the recording where it has none
  std::string fault;
};
[[nodiscard]] BagImage image_of(const rosbag::MessageInstance& message);

/// Nothing when it is no CameraInfo.
[[nodiscard]] std::optional<node::CameraInfoMessage> camera_info_of(const rosbag::MessageInstance& message);

}  // namespace adit::io
