#include "eval_pictures.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"

namespace adit::tools {
namespace {

constexpr int kThumbnailWidth_px = 360;
constexpr int kThumbnailQuality = 80;
constexpr double kOutlineTolerance_px = 1.5;  ///< at thumbnail size nobody sees less
constexpr double kAreaMin_px2 = 60.0;

std::vector<std::vector<Pixel>> open_area_of(const eval::FrameTruth& truth, const eval::ScoreConfig& config) {
  const eval::RangeImage& ranges = truth.ranges;
  if (ranges.range_m.empty() || truth.scene == eval::Scene::kNone) return {};
  const cv::Mat range_m(ranges.height, ranges.width, CV_32F, const_cast<float*>(ranges.range_m.data()));
  const cv::Mat open = range_m >= config.open_ratio_min * truth.far_m;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(open, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  std::vector<std::vector<Pixel>> area;
  for (const auto& contour : contours) {
    if (cv::contourArea(contour) < kAreaMin_px2) continue;
    std::vector<cv::Point> few;
    cv::approxPolyDP(contour, few, kOutlineTolerance_px, true);
    std::vector<Pixel>& outline = area.emplace_back();
    for (const cv::Point& p : few) outline.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  return area;
}

}  // namespace

void add_pictures(const cv::Mat& pixels, const eval::FrameTruth& truth, const Camera& camera,
                  const eval::ScoreConfig& config, JudgedFrame& judged) {
  cv::Mat small = io::bgr_of(pixels);
  if (small.cols > kThumbnailWidth_px)
    cv::resize(small, small, {kThumbnailWidth_px, std::max(1, small.rows * kThumbnailWidth_px / small.cols)}, 0.0, 0.0,
               cv::INTER_AREA);
  cv::imencode(".jpg", small, judged.thumbnail, {cv::IMWRITE_JPEG_QUALITY, kThumbnailQuality});
  judged.open_area = open_area_of(truth, config);
  for (const Bearing& branch : truth.branches)
    if (const auto place = camera.pixel_of(branch)) judged.branches.push_back(*place);
  if (truth.passage) judged.passage = camera.pixel_of(*truth.passage);
  if (truth.deepest) judged.deepest = camera.pixel_of(*truth.deepest);
}

}  // namespace adit::tools
