#include "adit/io/topic_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "adit/io/draw.hpp"
#include "adit/io/image_file.hpp"

namespace adit::io {
cv::Mat overlay_of(const ImageView& frame, const OpenSpace& open_space, const HeadingCommand& command,
                   int grey16_depth_bits) {
  cv::Mat bgr = bgr_of(mat_of(frame), grey16_depth_bits);
  draw_overlay(bgr, open_space, command);
  return bgr;
}

cv::Mat scattering_depth_levels(const StageImages& stages, const FinderConfig& config) {
  cv::Mat levels = cv::Mat::zeros(stages.height, stages.width, CV_8UC1);
  const double deepest = -std::log(config.transmission_min) / config.scattering_coefficient;
  std::transform(stages.closing.begin(), stages.closing.end(), levels.begin<std::uint8_t>(), [deepest](float depth) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(static_cast<double>(depth) / deepest, 0.0, 1.0)));
  });
  return levels;
}

}  // namespace adit::io
