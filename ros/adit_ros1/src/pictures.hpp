// Pixels to image messages and back.
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

namespace adit_ros1 {

/// @return pixels (grey or BGR, 8 or 16 bits), empty when the bytes are no image.
[[nodiscard]] cv::Mat decoded(const sensor_msgs::CompressedImage& image);

/// As a message, header aside.
[[nodiscard]] sensor_msgs::ImagePtr image_of(const cv::Mat& pixels);

}  // namespace adit_ros1
