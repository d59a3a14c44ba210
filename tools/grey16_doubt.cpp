#include "grey16_doubt.hpp"

#include <opencv2/core.hpp>

namespace adit::tools {

std::string grey16_doubt(const cv::Mat& pixels, int grey16_depth_bits) {
  if (pixels.type() != CV_16UC1 || pixels.empty()) return "";
  double brightest = 0.0;
  cv::minMaxLoc(pixels, nullptr, &brightest);
  const int value = static_cast<int>(brightest);
  const std::string set_to = std::to_string(grey16_depth_bits);
  if (value >> grey16_depth_bits != 0) {
    return "values up to " + std::to_string(value) + ", but grey16_depth_bits is " + set_to +
           ": all above are cut off; set grey16_depth_bits to the sensor's bits";
  }
  for (const int bits : {10, 12, 14}) {
    if (bits >= grey16_depth_bits || value >> bits != 0) continue;
    return "no value above " + std::to_string(value) + ", but grey16_depth_bits is " + set_to + ": if the sensor has " +
           std::to_string(bits) + " bits, --set grey16_depth_bits=" + std::to_string(bits);
  }
  return "";
}

}  // namespace adit::tools
