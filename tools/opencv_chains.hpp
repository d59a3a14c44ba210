// The published chain written with OpenCV, twice: what `adit bench` compares with, and what the tests cross-check.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "adit/finder.hpp"

namespace adit::tools {

/// What both chains answer: enough to see that they did the same work.
struct ChainAnswer {
  cv::Point2d centroid_px;
  double atmospheric_light = 0.0;
  double area_px = 0.0;
};

/// As one writes it from the paper: depth in float, closing of the float image, cv::kmeans with one random start of ten
/// iterations over all pixels. Buffers are kept from frame to frame.
class OpenCvChain {
 public:
  OpenCvChain(const FinderConfig& config, cv::Size frame);
  /// @param bgr  8-bit, 3 channels, of the size given.
  [[nodiscard]] ChainAnswer find(const cv::Mat& bgr);

 private:
  FinderConfig config_;
  cv::Mat patch_, element_, dark_, depth_, closed_, labels_, centres_, mask_;
  std::array<cv::Mat, 3> channels_;
};

/// As an engineer writes it who has seen that depth rises with the grey level: 8 bits to the end, one histogram,
/// our exact clustering of its 256 bins, a threshold. The same answer as method `paper`, pixel for pixel.
class StrongOpenCvChain {
 public:
  StrongOpenCvChain(const FinderConfig& config, cv::Size frame);
  [[nodiscard]] ChainAnswer find(const cv::Mat& bgr);

 private:
  FinderConfig config_;
  cv::Mat patch_, element_, dark_, closed_, mask_;
  std::array<cv::Mat, 3> channels_;
};

}  // namespace adit::tools
