#include "pictures.hpp"

#include <boost/make_shared.hpp>
#include <opencv2/imgcodecs.hpp>

namespace adit_ros1 {

sensor_msgs::ImagePtr image_of(const cv::Mat& pixels) {
  auto m = boost::make_shared<sensor_msgs::Image>();
  m->width = static_cast<std::uint32_t>(pixels.cols);
  m->height = static_cast<std::uint32_t>(pixels.rows);
  m->encoding = pixels.type() == CV_8UC1    ? "mono8"
                : pixels.type() == CV_16UC1 ? "mono16"
                : pixels.type() == CV_8UC4  ? "bgra8"
                                            : "bgr8";
  m->step = static_cast<std::uint32_t>(static_cast<std::size_t>(pixels.cols) * pixels.elemSize());
  m->data.reserve(std::size_t{m->step} * m->height);  // written once: not zeroed first
  if (pixels.isContinuous()) {
    m->data.assign(pixels.datastart, pixels.dataend);
  } else {
    for (int v = 0; v < pixels.rows; ++v) m->data.insert(m->data.end(), pixels.ptr(v), pixels.ptr(v) + m->step);
  }
  return m;
}

cv::Mat decoded(const sensor_msgs::CompressedImage& image) {
  try {
    return cv::imdecode(image.data, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace adit_ros1
