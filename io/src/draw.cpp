#include "adit/io/draw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "lettering.hpp"
#include "marks.hpp"

namespace adit::io {
namespace {

const cv::Scalar kRed(40, 40, 255);
const cv::Scalar kGreen(90, 235, 90);
const cv::Scalar kWhite(255, 255, 255);
const cv::Scalar kBlack(0, 0, 0);
const cv::Scalar kBanner(20, 60, 200);

constexpr double kFullArrow_rad_s = 1.0;  // a turn this fast makes the arrow half the frame long

std::string text_of(const char* format, double number) {
  char line[96];
  std::snprintf(line, sizeof line, format, number);
  return line;
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// The longest of the wordings that fits into the width; the last one is cut if none does.
std::string first_that_fits(std::initializer_list<std::string> wordings, const Lettering& lettering, int width_px) {
  for (const std::string& words : wordings) {
    if (size_of_text(words, lettering).width <= width_px) return words;
  }
  return fitted(*(wordings.end() - 1), lettering, width_px);
}

void draw_title(cv::Mat& bgr, const OpenSpace& open_space, const Scale& scale) {
  const int strip = static_cast<int>(std::lround(scale.text_px * 2.2));
  const int margin = static_cast<int>(std::lround(scale.text_px * 0.7));
  const int room = bgr.cols - 2 * margin;
  const cv::Point top(margin, static_cast<int>(std::lround(scale.text_px * 0.6)));
  Lettering lettering{scale.text_px, kWhite, false, Align::kLeft};
  if (open_space.found()) {
    tint(bgr, {0, 0, bgr.cols, strip}, kBlack, 0.6);
    const std::string confidence = text_of("%.2f", open_space.confidence);
    const std::string azimuth = text_of("%+.1f", degrees(open_space.bearing.azimuth_rad));
    const std::string elevation = text_of("%+.1f", degrees(open_space.bearing.elevation_rad));
    const std::string bearing = "azimuth " + azimuth + " deg  elevation " + elevation + " deg";
    const std::string words = first_that_fits({"open space found   confidence " + confidence + "   " + bearing,
                                               "found   confidence " + confidence + "   azimuth " + azimuth + " deg",
                                               "found " + confidence + "  " + azimuth + " deg", "found " + confidence},
                                              lettering, room);
    write_text(bgr, words, top, lettering);
    return;
  }
  tint(bgr, {0, 0, bgr.cols, strip}, kBanner, 0.85);
  lettering.bold = true;
  const std::string status(to_string(open_space.status));
  const std::string reason = reason_of(open_space.status);
  write_text(bgr, first_that_fits({"NO OPEN SPACE: " + reason, reason, "no: " + status, status}, lettering, room), top,
             lettering);
}

/// The commanded turn, as an arrow from the middle of the foot: right for a turn to the right.
void draw_command(cv::Mat& bgr, const HeadingCommand& command, const Scale& scale) {
  const int strip = static_cast<int>(std::lround(scale.text_px * 2.2));
  if (bgr.rows < 3 * strip) return;
  const int middle_v = bgr.rows - strip / 2;
  const double share = std::clamp(-command.yaw_rate_rad_s / kFullArrow_rad_s, -1.0, 1.0);
  tint(bgr, {0, bgr.rows - strip, bgr.cols, strip}, kBlack, 0.6);
  const cv::Point foot(bgr.cols / 2, middle_v);
  const cv::Point tip(foot.x + static_cast<int>(std::lround(share * (bgr.cols * 0.5 - scale.text_px))), middle_v);
  cv::line(bgr, {foot.x, middle_v - strip / 3}, {foot.x, middle_v + strip / 3}, kWhite, scale.line_px, cv::LINE_AA);
  draw_arrow(bgr, foot, tip, kGreen, scale);
  const std::string state(to_string(command.state));
  const std::string rate = text_of("%.2f", std::abs(command.yaw_rate_rad_s));
  const bool turns = std::abs(command.yaw_rate_rad_s) >= 0.005;
  const std::string side = command.yaw_rate_rad_s > 0.0 ? "left" : "right";
  const std::string words = turns ? state + ": turn " + side + " " + rate + " rad/s" : state + ": straight on";
  const std::string brief = turns ? side + " " + rate : state;
  // The words stand on the side the arrow leaves free.
  const bool on_right = share < 0.0;
  const int margin = static_cast<int>(std::lround(scale.text_px * 0.7));
  const Lettering lettering{scale.text_px, kWhite, false, on_right ? Align::kRight : Align::kLeft};
  const std::string wanted = command.state == HeadingState::kHold ? "hold: no turn" : words;
  write_text(bgr, first_that_fits({wanted, brief}, lettering, bgr.cols / 2 - 2 * margin),
             {on_right ? bgr.cols - margin : margin, middle_v - static_cast<int>(scale.text_px / 2)}, lettering);
}

}  // namespace

cv::Mat bgr_of(const cv::Mat& frame, int grey16_depth_bits) {
  if (frame.empty()) throw std::invalid_argument("bgr_of: the frame is empty");
  if (frame.type() == CV_16UC1) {
    if (grey16_depth_bits < 8 || grey16_depth_bits > 16) {
      throw std::invalid_argument("grey16_depth_bits: " + std::to_string(grey16_depth_bits) + " is not in [8, 16]");
    }
    cv::Mat grey;
    // Half a level off, so that rounding cuts off as the finder's shift does.
    frame.convertTo(grey, CV_8U, 1.0 / (1 << (grey16_depth_bits - 8)), -0.499);
    return bgr_of(grey);
  }
  cv::Mat bgr;
  switch (frame.type()) {
    case CV_8UC1:
      cv::cvtColor(frame, bgr, cv::COLOR_GRAY2BGR);
      return bgr;
    case CV_8UC3:
      return frame.clone();
    case CV_8UC4:
      cv::cvtColor(frame, bgr, cv::COLOR_BGRA2BGR);
      return bgr;
    default:
      throw std::invalid_argument("bgr_of: OpenCV type " + std::to_string(frame.type()) +
                                  " is not 8-bit with 1, 3 or 4 channels nor 16-bit grey");
  }
}

void draw_overlay(cv::Mat& bgr, const OpenSpace& open_space, std::optional<HeadingCommand> command) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    throw std::invalid_argument("draw_overlay: the picture must be 8-bit with 3 channels");
  }
  const Scale scale = scale_of(bgr.size());
  if (open_space.found()) draw_circle(bgr, open_space.centroid_px, kRed, scale);
  if (!scale.has_text) return;
  draw_title(bgr, open_space, scale);
  if (command) draw_command(bgr, *command, scale);
}

}  // namespace adit::io
