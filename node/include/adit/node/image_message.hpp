// A frame as messages carry it (ROS's sensor_msgs/Image, Gazebo's ignition.msgs.Image), and the view that the finder
// takes of it: nothing is copied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "adit/image.hpp"
#include "adit/node/time.hpp"

namespace adit::node {

/// Borrowed: the pixels belong to the message.
struct ImageMessage {
  Time_ns stamp_ns = 0;       ///< when it was taken; 0: the driver does not say
  std::string_view frame_id;  ///< of the optical frame: x right, y down, z forward (REP 103)
  std::uint32_t width = 0;    ///< px
  std::uint32_t height = 0;   ///< px
  std::string_view encoding;  ///< as in sensor_msgs/image_encodings.h
  bool is_bigendian = false;  ///< of 16-bit pixels
  std::uint32_t step = 0;     ///< bytes of a row
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;  ///< bytes of all rows
};

/// What can be read of a message.
struct ImageReading {
  ImageView view;     ///< without data when there is a fault
  std::string fault;  ///< one line that names the field and the value; empty when the frame can be judged
  bool is_unknown_encoding = false;
};

/// Encodings: mono8, 8UC1, bgr8, 8UC3, rgb8, bgra8, 8UC4, rgba8, mono16, 16UC1 (16 bits in this machine's byte order).
[[nodiscard]] ImageReading view_of(const ImageMessage& message);

}  // namespace adit::node
