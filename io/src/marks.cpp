#include "marks.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace adit::io {
namespace {

constexpr int kFractionBits = 4;  // circles are placed to a sixteenth of a pixel

int fixed(double px) { return static_cast<int>(std::lround(px * (1 << kFractionBits))); }

void fill_head(cv::Mat& bgr, cv::Point2d tip, cv::Point2d along, double length, const cv::Scalar& colour) {
  const cv::Point2d across(-along.y, along.x);
  const cv::Point2d base = tip - along * length;
  std::vector<cv::Point> corners;
  for (const cv::Point2d& corner : {tip, base + across * (length * 0.6), base - across * (length * 0.6)}) {
    corners.emplace_back(fixed(corner.x), fixed(corner.y));
  }
  cv::fillConvexPoly(bgr, corners, colour, cv::LINE_AA, kFractionBits);
}

}  // namespace

Scale scale_of(cv::Size picture) {
  const double side_px = std::min(picture.width / 640.0, picture.height / 480.0) * 480.0;
  Scale scale;
  scale.text_px = std::max(7.0, side_px / 480.0 * 12.0);
  scale.line_px = std::max(1, static_cast<int>(std::lround(side_px / 480.0 * 2.0)));
  scale.radius_px = std::max(3, static_cast<int>(std::lround(side_px / 480.0 * 16.0)));
  scale.has_text = picture.width >= 96 && picture.height >= 48;
  return scale;
}

void draw_circle(cv::Mat& bgr, Pixel centre, const cv::Scalar& colour, const Scale& scale) {
  const cv::Point at(fixed(centre.u_px), fixed(centre.v_px));
  const int radius = fixed(scale.radius_px);
  cv::circle(bgr, at, radius, cv::Scalar(0, 0, 0), 2 * scale.line_px + 2, cv::LINE_AA, kFractionBits);
  cv::circle(bgr, at, radius, colour, scale.line_px + 1, cv::LINE_AA, kFractionBits);
  cv::circle(bgr, at, fixed(std::max(1.0, scale.radius_px * 0.18)), colour, cv::FILLED, cv::LINE_AA, kFractionBits);
}

void draw_arrow(cv::Mat& bgr, cv::Point from, cv::Point to, const cv::Scalar& colour, const Scale& scale) {
  const cv::Point2d way = cv::Point2d(to) - cv::Point2d(from);
  const double length = std::hypot(way.x, way.y);
  if (length < scale.line_px + 1.0) return;
  const cv::Point2d along = way * (1.0 / length);
  const double head = std::min(length, scale.text_px * 0.9);
  const cv::Point neck(cv::Point2d(to) - along * (head * 0.8));
  cv::line(bgr, from, neck, cv::Scalar(0, 0, 0), 2 * scale.line_px + 3, cv::LINE_AA);
  fill_head(bgr, cv::Point2d(to) + along * 1.0, along, head + 2.0, cv::Scalar(0, 0, 0));
  cv::line(bgr, from, neck, colour, scale.line_px + 1, cv::LINE_AA);
  fill_head(bgr, cv::Point2d(to), along, head, colour);
}

std::string reason_of(Status status) {
  switch (status) {
    case Status::kFound:
      return "open space found";
    case Status::kTooDark:
      return "too dark (lamp out, lens covered?)";
    case Status::kTooBright:
      return "too bright (daylight, overexposed?)";
    case Status::kNoContrast:
      return "no contrast (fog, one grey value?)";
    case Status::kNoRegion:
      return "no dark region large enough";
    case Status::kBadFrame:
      return "not a frame";
    case Status::kWrongSize:
      return "frame is not of the camera's size";
    case Status::kNoOpening:
      return "rock, and no way through it";
    case Status::kBlockedLens:
      return "something covers the lens";
    case Status::kDust:
      return "dust hides the rock";
    case Status::kFrozenFrame:
      return "the camera hangs";
    case Status::kTornFrame:
      return "a broken frame";
  }
  return std::string(to_string(status));
}

}  // namespace adit::io
