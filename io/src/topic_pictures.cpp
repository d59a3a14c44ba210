#include "adit/io/topic_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"

namespace adit::io {
namespace {

/// OpenCV's order of colours; shares the pixels where that is theirs.
cv::Mat mat_of(const ImageView& view) {
  const int type = view.format == PixelFormat::kGrey8    ? CV_8UC1
                   : view.format == PixelFormat::kGrey16 ? CV_16UC1
                   : bytes_per_pixel(view.format) == 3   ? CV_8UC3
                                                         : CV_8UC4;
  cv::Mat mat(view.height, view.width, type, const_cast<std::uint8_t*>(view.data),
              static_cast<std::size_t>(view.stride_bytes));
  if (view.format != PixelFormat::kRgb8 && view.format != PixelFormat::kRgba8) return mat;
  cv::Mat turned;
  cv::cvtColor(mat, turned, view.format == PixelFormat::kRgb8 ? cv::COLOR_RGB2BGR : cv::COLOR_RGBA2BGRA);
  return turned;
}

}  // namespace

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
