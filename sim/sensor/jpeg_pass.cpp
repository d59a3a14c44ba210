// The frame as a camera with a JPEG stream would deliver it.
#include <cstring>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>

#include "../light/parts.hpp"

namespace adit::sim {

void jpeg_pass(const SensorConfig& sensor, Frame& frame) {
  if (sensor.jpeg_quality <= 0) return;
  const cv::Mat image(frame.height, frame.width, CV_8UC3, frame.bgr.data());
  std::vector<std::uint8_t> packed;
  cv::imencode(".jpg", image, packed, {cv::IMWRITE_JPEG_QUALITY, sensor.jpeg_quality});
  const cv::Mat back = cv::imdecode(packed, cv::IMREAD_COLOR);
  std::memcpy(frame.bgr.data(), back.data, frame.bgr.size());
}

}  // namespace adit::sim
