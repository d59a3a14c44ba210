#include "opencv_chains.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "adit/kmeans.hpp"
#include "adit/scattering_depth.hpp"

namespace adit::tools {
namespace {

cv::Mat element_of(int shape, int set_px, int vga_px, cv::Size frame) {
  const int size = set_px > 0 ? set_px : scaled_size_px(vga_px, frame.width);
  return cv::getStructuringElement(shape, {size, size});
}

/// Eq. (3): the dark channel.
void dark_channel_of(const cv::Mat& bgr, const cv::Mat& patch, std::array<cv::Mat, 3>& channels, cv::Mat& dark) {
  cv::split(bgr, channels.data());
  cv::min(channels[0], channels[1], channels[0]);
  cv::min(channels[0], channels[2], channels[0]);
  cv::erode(channels[0], dark, patch);
}

cv::Mat histogram_of(const cv::Mat& grey) {
  const int channel = 0, bins = 256;
  const float range[] = {0.0F, 256.0F};
  const float* ranges[] = {range};
  cv::Mat histogram;
  cv::calcHist(&grey, 1, &channel, {}, histogram, 1, &bins, ranges);
  return histogram;
}

/// He et al.: the mean brightness where the dark channel is among the brightest.
double atmospheric_light_of(const cv::Mat& bgr, const cv::Mat& dark, double fraction, cv::Mat& mask) {
  const cv::Mat histogram = histogram_of(dark);
  const double wanted = std::max(1.0, std::ceil(fraction * static_cast<double>(dark.total())));
  double counted = 0.0;
  int level = 256;
  while (level > 0 && counted < wanted) counted += histogram.at<float>(--level);
  cv::compare(dark, level, mask, cv::CMP_GE);
  const cv::Scalar mean = cv::mean(bgr, mask);
  return (mean[0] + mean[1] + mean[2]) / 3.0;
}

/// Eq. (8) and (9).
ChainAnswer answer_of(const cv::Mat& mask, double atmospheric_light) {
  const cv::Moments moments = cv::moments(mask, true);
  return {{moments.m10 / moments.m00, moments.m01 / moments.m00}, atmospheric_light, moments.m00};
}

}  // namespace

OpenCvChain::OpenCvChain(const FinderConfig& config, cv::Size frame)
    : config_(config),
      patch_(element_of(cv::MORPH_RECT, config.patch_size_px, config.patch_size_vga_px, frame)),
      element_(element_of(cv::MORPH_ELLIPSE, config.structuring_element_size_px, config.structuring_element_size_vga_px,
                          frame)) {}

ChainAnswer OpenCvChain::find(const cv::Mat& bgr) {
  dark_channel_of(bgr, patch_, channels_, dark_);
  const double a = atmospheric_light_of(bgr, dark_, config_.atmospheric_light_fraction, mask_);
  dark_.convertTo(depth_, CV_32F, a > 0.0 ? -config_.omega / a : 0.0, 1.0);  // eq. (3): t
  cv::max(depth_, config_.transmission_min, depth_);
  cv::log(depth_, depth_);
  depth_ *= -1.0 / config_.scattering_coefficient;               // eq. (2): d
  cv::morphologyEx(depth_, closed_, cv::MORPH_CLOSE, element_);  // eq. (4), (5)
  const cv::Mat samples = closed_.reshape(1, static_cast<int>(closed_.total()));
  const cv::TermCriteria ten_iterations(cv::TermCriteria::COUNT, 10, 0.0);
  cv::kmeans(samples, config_.cluster_count, labels_, ten_iterations, 1, cv::KMEANS_RANDOM_CENTERS,
             centres_);  // eq. (6), (7)
  cv::Point darkest;
  cv::minMaxLoc(centres_, nullptr, nullptr, &darkest, nullptr);
  cv::compare(labels_.reshape(1, bgr.rows), darkest.y, mask_, cv::CMP_EQ);
  return answer_of(mask_, a);
}

StrongOpenCvChain::StrongOpenCvChain(const FinderConfig& config, cv::Size frame)
    : config_(config),
      patch_(element_of(cv::MORPH_RECT, config.patch_size_px, config.patch_size_vga_px, frame)),
      element_(element_of(cv::MORPH_ELLIPSE, config.structuring_element_size_px, config.structuring_element_size_vga_px,
                          frame)) {}

ChainAnswer StrongOpenCvChain::find(const cv::Mat& bgr) {
  dark_channel_of(bgr, patch_, channels_, dark_);
  const double a = atmospheric_light_of(bgr, dark_, config_.atmospheric_light_fraction, mask_);
  const LevelTable depth = scattering_depth_table(transmission_table(a, config_.omega, config_.transmission_min),
                                                  config_.scattering_coefficient);
  cv::morphologyEx(dark_, closed_, cv::MORPH_CLOSE, element_);
  const cv::Mat counted = histogram_of(closed_);
  Histogram histogram{};
  for (int level = 0; level < 256; ++level) {
    histogram[static_cast<std::size_t>(level)] = static_cast<std::uint32_t>(counted.at<float>(level));
  }
  const Clusters clusters = cluster_exact(depth, histogram, config_.cluster_count);
  cv::threshold(closed_, mask_, clusters.last_level[0], 255, cv::THRESH_BINARY_INV);
  return answer_of(mask_, a);
}

}  // namespace adit::tools
