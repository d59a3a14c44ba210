#include "adit/io/image_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "adit/io/errors.hpp"

namespace adit::io {

bool is_image_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array kKnown{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm", ".ppm"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

cv::Mat read_image(const std::filesystem::path& path) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED | cv::IMREAD_IGNORE_ORIENTATION);
  if (image.empty()) throw InputError(path.string() + ": not an image that can be read");
  return image;
}

ImageView view_of(const cv::Mat& image) noexcept {
  ImageView view;
  switch (image.type()) {
    case CV_8UC1:
      view.format = PixelFormat::kGrey8;
      break;
    case CV_8UC3:
      view.format = PixelFormat::kBgr8;
      break;
    case CV_8UC4:
      view.format = PixelFormat::kBgra8;
      break;
    case CV_16UC1:
      view.format = PixelFormat::kGrey16;
      break;
    default:
      return view;
  }
  view.data = image.data;
  view.width = image.cols;
  view.height = image.rows;
  view.stride_bytes = static_cast<std::ptrdiff_t>(image.step[0]);
  return view;
}

}  // namespace adit::io
