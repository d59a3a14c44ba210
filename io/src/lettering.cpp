#include "lettering.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace adit::io {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kCapitalHeight_units = 21.0;  // of the Hershey fonts at scale 1
constexpr double kLineSpacing = 1.75;          // capital heights from line to line
constexpr int kEnlargedHeight_px = 48;         // strokes are smooth once drawn this large and shrunk

/// The line in white on black, drawn large.
struct Enlarged {
  cv::Mat mask;
  double factor = 1.0;  // enlarged pixels per pixel
  int baseline_px = 0;  // enlarged
  int margin_px = 0;    // enlarged
};

struct Stroke {
  double scale;
  int thickness;
  double factor;
};

Stroke stroke_of(const Lettering& lettering) {
  const double factor = std::max(1.0, std::ceil(kEnlargedHeight_px / lettering.height_px));
  const double height_px = lettering.height_px * factor;
  const double share = lettering.bold ? 0.14 : 0.085;
  return {height_px / kCapitalHeight_units, std::max(1, static_cast<int>(std::lround(height_px * share))), factor};
}

Enlarged enlarged(const std::string& text, const Lettering& lettering) {
  const Stroke stroke = stroke_of(lettering);
  Enlarged out;
  out.factor = stroke.factor;
  out.margin_px = stroke.thickness;
  const cv::Size size = cv::getTextSize(text, kFont, stroke.scale, stroke.thickness, &out.baseline_px);
  const int capital = static_cast<int>(std::lround(lettering.height_px * stroke.factor));
  const auto whole = [&](int px) { return static_cast<int>(std::ceil(px / out.factor) * out.factor); };
  out.mask = cv::Mat::zeros(whole(capital + out.baseline_px + 2 * out.margin_px),
                            whole(std::max(1, size.width) + 2 * out.margin_px), CV_8UC1);
  cv::putText(out.mask, text, {out.margin_px, out.margin_px + capital}, kFont, stroke.scale, cv::Scalar(255),
              stroke.thickness, cv::LINE_AA);
  return out;
}

void blend(cv::Mat& bgr, const cv::Mat& mask, cv::Point corner, const cv::Scalar& colour) {
  const cv::Rect seen = cv::Rect(corner, mask.size()) & cv::Rect(0, 0, bgr.cols, bgr.rows);
  for (int v = seen.y; v < seen.y + seen.height; ++v) {
    auto* pixel = bgr.ptr<cv::Vec3b>(v);
    const auto* ink = mask.ptr<std::uint8_t>(v - corner.y);
    for (int u = seen.x; u < seen.x + seen.width; ++u) {
      const int share = ink[u - corner.x];
      for (int c = 0; c < 3; ++c) {
        const double mixed = (pixel[u][c] * (255 - share) + colour[c] * share) / 255.0;
        pixel[u][c] = static_cast<std::uint8_t>(std::lround(mixed));
      }
    }
  }
}

}  // namespace

cv::Size size_of_text(const std::string& text, const Lettering& lettering) {
  const Stroke stroke = stroke_of(lettering);
  int baseline = 0;
  const cv::Size size = cv::getTextSize(text, kFont, stroke.scale, stroke.thickness, &baseline);
  return {static_cast<int>(std::ceil(size.width / stroke.factor)),
          static_cast<int>(std::ceil(lettering.height_px + baseline / stroke.factor))};
}

void write_text(cv::Mat& bgr, const std::string& text, cv::Point top, const Lettering& lettering) {
  if (text.empty() || bgr.empty() || lettering.height_px < 1.0) return;
  const Enlarged large = enlarged(text, lettering);
  cv::Mat mask;
  cv::resize(large.mask, mask, {}, 1.0 / large.factor, 1.0 / large.factor, cv::INTER_AREA);
  const int margin = static_cast<int>(std::lround(large.margin_px / large.factor));
  int left = top.x - margin;
  if (lettering.align != Align::kLeft) {
    const int width = size_of_text(text, lettering).width;
    left -= lettering.align == Align::kCentre ? width / 2 : width;
  }
  blend(bgr, mask, {left, top.y - margin}, lettering.colour);
}

int write_lines(cv::Mat& bgr, const std::string& text, cv::Point top, const Lettering& lettering) {
  const int step = static_cast<int>(std::lround(lettering.height_px * kLineSpacing));
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    write_text(bgr, text.substr(begin, end - begin), top, lettering);
    top.y += step;
    begin = end + 1;
  }
  return top.y;
}

void tint(cv::Mat& bgr, cv::Rect box, const cv::Scalar& colour, double share) {
  box &= cv::Rect(0, 0, bgr.cols, bgr.rows);
  if (box.empty()) return;
  cv::Mat part = bgr(box);
  cv::addWeighted(part, 1.0 - share, cv::Mat(part.size(), part.type(), colour), share, 0.0, part);
}

std::string fitted(const std::string& text, const Lettering& lettering, int width_px) {
  if (size_of_text(text, lettering).width <= width_px) return text;
  for (std::size_t length = text.size(); length > 0; --length) {
    const std::string shorter = text.substr(0, length - 1) + "..";
    if (size_of_text(shorter, lettering).width <= width_px) return shorter;
  }
  return "";
}

}  // namespace adit::io
