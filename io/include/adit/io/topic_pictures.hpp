// The pictures that nodes send for people, the same for ROS 1 and ROS 2: made here, put into messages there.
#pragma once

#include <opencv2/core/mat.hpp>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/image.hpp"

namespace adit::io {

/// The frame with its answer drawn in, 8-bit BGR whatever the frame's order of colours; pixels of its own.
/// @param frame  any format that the finder takes, with data.
/// @param grey16_depth_bits  as FinderConfig::grey16_depth_bits.
[[nodiscard]] cv::Mat overlay_of(const ImageView& frame, const OpenSpace& open_space, const HeadingCommand& command,
                                 int grey16_depth_bits);

/// The closed scattering depth in 8 bits, of the stages' size: 0 is far (black), 255 the depth at transmission_min. It
/// is not metric, and not called depth (REP 118).
[[nodiscard]] cv::Mat scattering_depth_levels(const StageImages& stages, const FinderConfig& config);

}  // namespace adit::io
