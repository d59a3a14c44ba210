// The calibration as messages carry it (ROS's sensor_msgs/CameraInfo, Gazebo's ignition.msgs.CameraInfo).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/image.hpp"

namespace adit::node {

/// sensor_msgs/CameraInfo, the part that one camera alone needs.
struct CameraInfoMessage {
  std::uint32_t width = 0;   ///< px, of the whole sensor
  std::uint32_t height = 0;  ///< px
  std::string distortion_model;
  std::vector<double> distortion;  ///< D
  std::array<double, 9> matrix{};  ///< K, row by row; K[0] is 0 where the camera was never calibrated
  std::uint32_t binning_x = 0;     ///< 0 and 1: none
  std::uint32_t binning_y = 0;
  std::uint32_t roi_x_offset = 0;  ///< px of the whole sensor
  std::uint32_t roi_y_offset = 0;
  std::uint32_t roi_width = 0;  ///< 0: the whole sensor
  std::uint32_t roi_height = 0;
};

struct CameraReading {
  std::optional<CameraModel> model;  ///< of the images as they are published: after region and binning
  std::string fault;                 ///< one line; empty with a model, and for a camera that was never calibrated
};

/// A driver without calibration sends zeros: neither model nor fault.
[[nodiscard]] CameraReading camera_of(const CameraInfoMessage& message);

}  // namespace adit::node
