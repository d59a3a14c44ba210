// What is drawn on top of frames and depth maps: the paper's red circle, arrows, and how large all that is.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "adit/finder.hpp"

namespace adit::io {

/// Sizes that grow with the picture.
struct Scale {
  double text_px = 12.0;  ///< height of a capital letter
  int line_px = 1;        ///< width of a line
  int radius_px = 8;      ///< of the red circle
  bool has_text = true;   ///< the picture is large enough for a line of text
};

[[nodiscard]] Scale scale_of(cv::Size picture);

/// The paper's circle, with a dark rim so that it is seen on bright rock too.
void draw_circle(cv::Mat& bgr, Pixel centre, const cv::Scalar& colour, const Scale& scale);

/// An arrow with a filled head, with a dark rim; nothing when it is shorter than a line is wide.
void draw_arrow(cv::Mat& bgr, cv::Point from, cv::Point to, const cv::Scalar& colour, const Scale& scale);

/// A status that is not kFound, in words for a person.
[[nodiscard]] std::string reason_of(Status status);

}  // namespace adit::io
