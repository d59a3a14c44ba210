// Pictures for people, made only while somebody looks.
#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

#include "adit/finder.hpp"
#include "adit/image.hpp"
#include "adit/node/perception.hpp"

namespace adit_ros1 {

/// The closed scattering depth, mono8: 0 is far (black), 255 the depth at transmission_min. It is not metric, and it is
/// not called depth (REP 118).
[[nodiscard]] sensor_msgs::ImagePtr scattering_depth_image(const adit::StageImages& stages,
                                                           const adit::FinderConfig& config);

/// The frame with its opening, bgr8.
[[nodiscard]] sensor_msgs::ImagePtr overlay_image(const adit::ImageView& frame, const adit::node::Sighting& sighting,
                                                  int grey16_depth_bits);

/// @return pixels (grey or BGR, 8 or 16 bits), empty when the bytes are no image.
[[nodiscard]] cv::Mat decoded(const sensor_msgs::CompressedImage& image);

/// As a message, header aside.
[[nodiscard]] sensor_msgs::ImagePtr image_of(const cv::Mat& pixels);

}  // namespace adit_ros1
