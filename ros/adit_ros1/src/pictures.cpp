#include "pictures.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"

namespace adit_ros1 {
namespace {

/// Shares the pixels; OpenCV's order of colours.
cv::Mat mat_of(const adit::ImageView& view) {
  using adit::PixelFormat;
  const bool is_grey = view.format == PixelFormat::kGrey8;
  const int type = is_grey                               ? CV_8UC1
                   : view.format == PixelFormat::kGrey16 ? CV_16UC1
                   : bytes_per_pixel(view.format) == 3   ? CV_8UC3
                                                         : CV_8UC4;
  cv::Mat mat(view.height, view.width, type, const_cast<std::uint8_t*>(view.data),
              static_cast<std::size_t>(view.stride_bytes));
  if (view.format != PixelFormat::kRgb8 && view.format != PixelFormat::kRgba8) return mat;
  cv::Mat turned;
  cv::cvtColor(mat, turned, view.format == PixelFormat::kRgb8 ? cv::COLOR_RGB2BGR : cv::COLOR_RGBA2BGRA);
  return turned;
}

}  // namespace

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

sensor_msgs::ImagePtr scattering_depth_image(const adit::StageImages& stages, const adit::FinderConfig& config) {
  auto m = boost::make_shared<sensor_msgs::Image>();
  m->width = static_cast<std::uint32_t>(stages.width);
  m->height = static_cast<std::uint32_t>(stages.height);
  m->encoding = "mono8";
  m->step = m->width;
  m->data.resize(stages.closing.size());
  const double deepest = -std::log(config.transmission_min) / config.scattering_coefficient;
  std::transform(stages.closing.begin(), stages.closing.end(), m->data.begin(), [deepest](float depth) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(static_cast<double>(depth) / deepest, 0.0, 1.0)));
  });
  return m;
}

sensor_msgs::ImagePtr overlay_image(const adit::ImageView& frame, const adit::node::Sighting& sighting,
                                    int grey16_depth_bits) {
  cv::Mat bgr = adit::io::bgr_of(mat_of(frame), grey16_depth_bits);
  adit::io::draw_overlay(bgr, sighting.open_space, sighting.heading);
  return image_of(bgr);
}

cv::Mat decoded(const sensor_msgs::CompressedImage& image) {
  try {
    return cv::imdecode(image.data, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace adit_ros1
