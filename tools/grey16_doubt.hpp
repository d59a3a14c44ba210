// Does a 16-bit grey frame look like one of a sensor with fewer bits?
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace adit::tools {

/// A line when the frame's brightest value does not fit grey16_depth_bits: far below, as from a 10-, 12- or 14-bit
/// sensor, or above. Empty otherwise, and for frames of other types.
[[nodiscard]] std::string grey16_doubt(const cv::Mat& pixels, int grey16_depth_bits);

}  // namespace adit::tools
