// Words in pictures: OpenCV's stroke font, drawn large and shrunk, so that it stays legible at every size.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace adit::io {

/// Where a line of text stands relative to the point it is given.
enum class Align { kLeft, kCentre, kRight };

/// How a line is written. The height is that of a capital letter.
struct Lettering {
  double height_px = 12.0;
  cv::Scalar colour{255, 255, 255};
  bool bold = false;
  Align align = Align::kLeft;
};

/// Room that a line takes, in pixels: width, and height from the top of a capital to the bottom of a descender.
[[nodiscard]] cv::Size size_of_text(const std::string& text, const Lettering& lettering);

/// Writes one line of ASCII, `top` being the top of its capitals at the aligned edge. Parts outside are cut off.
void write_text(cv::Mat& bgr, const std::string& text, cv::Point top, const Lettering& lettering);

/// Writes lines one below the other and returns the row below the last.
int write_lines(cv::Mat& bgr, const std::string& text, cv::Point top, const Lettering& lettering);

/// Darkens (or tints) a rectangle so that text on it can be read. `share` is how much of the colour is laid over.
void tint(cv::Mat& bgr, cv::Rect box, const cv::Scalar& colour, double share);

/// The text shortened with ".." so that it fits into width_px; empty when not even that fits.
[[nodiscard]] std::string fitted(const std::string& text, const Lettering& lettering, int width_px);

}  // namespace adit::io
