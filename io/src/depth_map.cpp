// The scattering depth in colour, and Figure 2 of the paper.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "adit/io/draw.hpp"
#include "lettering.hpp"
#include "marks.hpp"

namespace adit::io {
namespace {

const cv::Scalar kNoDepth(64, 64, 64);

bool is_whole(const std::vector<float>& plane, const StageImages& stages) {
  return stages.width > 0 && stages.height > 0 &&
         plane.size() == static_cast<std::size_t>(stages.width) * static_cast<std::size_t>(stages.height);
}

/// A bar of the map's colours at the foot, "far" at its dark end and "near" at its bright one.
void draw_key(cv::Mat& map, const Scale& scale) {
  const int strip = static_cast<int>(std::lround(scale.text_px * 2.2));
  if (!scale.has_text || map.rows < 3 * strip) return;
  const int top = map.rows - strip;
  const int margin = static_cast<int>(std::lround(scale.text_px * 0.7));
  const Lettering left{scale.text_px, cv::Scalar(255, 255, 255), false, Align::kLeft};
  Lettering right = left;
  right.align = Align::kRight;
  const bool roomy = map.cols > 24.0 * scale.text_px;
  const std::string far = roomy ? "dark = far" : "far";
  const std::string near = roomy ? "bright = near" : "near";
  tint(map, {0, top, map.cols, strip}, cv::Scalar(0, 0, 0), 0.6);
  const int text_v = top + static_cast<int>(std::lround((strip - scale.text_px) / 2));
  write_text(map, far, {margin, text_v}, left);
  write_text(map, near, {map.cols - margin, text_v}, right);
  const int begin = 2 * margin + size_of_text(far, left).width;
  const int end = map.cols - 2 * margin - size_of_text(near, right).width;
  if (end - begin < 8) return;
  cv::Mat ramp(1, end - begin, CV_8UC1);
  for (int u = 0; u < ramp.cols; ++u)
    ramp.at<std::uint8_t>(0, u) = static_cast<std::uint8_t>(255 * u / (ramp.cols - 1));
  cv::Mat colours;
  cv::applyColorMap(ramp, colours, cv::COLORMAP_INFERNO);
  const cv::Rect bar(begin, top + strip / 3, end - begin, std::max(1, strip / 3));
  cv::resize(colours, map(bar), bar.size(), 0, 0, cv::INTER_NEAREST);
  cv::rectangle(map, bar, cv::Scalar(160, 160, 160), 1);
}

void draw_map_title(cv::Mat& map, bool has_depth, const Scale& scale) {
  if (!scale.has_text) return;
  const int margin = static_cast<int>(std::lround(scale.text_px * 0.7));
  const Lettering lettering{scale.text_px, cv::Scalar(255, 255, 255), false, Align::kLeft};
  tint(map, {0, 0, map.cols, static_cast<int>(std::lround(scale.text_px * 2.2))}, cv::Scalar(0, 0, 0), 0.6);
  const std::string words = has_depth ? "scattering depth after closing (unitless)" : "no depth map";
  const std::string brief = has_depth ? "scattering depth" : "no depth";
  const int room = map.cols - 2 * margin;
  const bool fits = size_of_text(words, lettering).width <= room;
  write_text(map, fits ? words : fitted(brief, lettering, room),
             {margin, static_cast<int>(std::lround(scale.text_px * 0.6))}, lettering);
}

}  // namespace

cv::Mat depth_map(const StageImages& stages) {
  if (!is_whole(stages.closing, stages)) {
    return {std::max(1, stages.height), std::max(1, stages.width), CV_8UC3, kNoDepth};
  }
  const auto [low, high] = std::minmax_element(stages.closing.begin(), stages.closing.end());
  const double span = static_cast<double>(*high) - *low;
  cv::Mat levels(stages.height, stages.width, CV_8UC1);
  const float* depth = stages.closing.data();
  for (int v = 0; v < stages.height; ++v) {
    auto* row = levels.ptr<std::uint8_t>(v);
    for (int u = 0; u < stages.width; ++u, ++depth) {
      // A map of one depth is drawn as far: nothing in it is known to be near.
      const double share = span > 0.0 ? std::sqrt((*depth - *low) / span) : 0.0;
      row[u] = static_cast<std::uint8_t>(std::lround(255.0 * share));
    }
  }
  cv::Mat colours;
  cv::applyColorMap(levels, colours, cv::COLORMAP_INFERNO);
  return colours;
}

cv::Mat side_by_side(const cv::Mat& frame, const OpenSpace& open_space, const StageImages& stages,
                     std::optional<HeadingCommand> command) {
  cv::Mat left = bgr_of(frame);
  draw_overlay(left, open_space, command);
  const bool has_depth = is_whole(stages.closing, stages);
  cv::Mat right = has_depth ? depth_map(stages) : cv::Mat(left.size(), CV_8UC3, kNoDepth);
  if (right.size() != left.size()) {
    throw std::invalid_argument("side_by_side: the stage pictures are " + std::to_string(stages.width) + " x " +
                                std::to_string(stages.height) + " px, the frame is " + std::to_string(left.cols) +
                                " x " + std::to_string(left.rows) + " px");
  }
  const Scale scale = scale_of(right.size());
  if (open_space.found()) draw_circle(right, open_space.centroid_px, cv::Scalar(40, 40, 255), scale);
  draw_map_title(right, has_depth, scale);
  if (has_depth) draw_key(right, scale);
  cv::Mat both;
  cv::hconcat(left, right, both);
  return both;
}

}  // namespace adit::io
