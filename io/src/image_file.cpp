#include "adit/io/image_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "adit/io/errors.hpp"
#include "image_bytes.hpp"
#include "text_file.hpp"

namespace adit::io {
namespace {

/// Everything but JPEG. Returns why not, "" when the image is whole.
std::string decode_by_opencv(const Bytes& bytes, cv::Mat& image) {
  try {
    image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {  // sizes beyond OpenCV's limits
    image.release();
  }
  return image.empty() ? "truncated, damaged, or not an image of a kind that is read (png, jpg, bmp, tif, pgm, ppm)"
                       : "";
}

std::string decode(const Bytes& bytes, cv::Mat& image) {
  if (is_jpeg(bytes)) return decode_jpeg(bytes, image);
  if (!is_png(bytes)) return decode_by_opencv(bytes, image);
  Bytes plain;
  const std::string fault = check_png(bytes, plain);
  return fault.empty() ? decode_by_opencv(plain, image) : fault;
}

/// Brings what the finder does not take (16-bit colour) to what it does. Returns why that cannot be.
std::string to_known_type(cv::Mat& image) {
  if (image.depth() == CV_16U && image.channels() > 1) image.convertTo(image, CV_8U, 1.0 / 257.0);
  if (view_of(image).data != nullptr) return "";
  return "its pixels are neither 8-bit grey or colour nor 16-bit grey";
}

}  // namespace

bool is_image_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array kKnown{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm", ".ppm"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

cv::Mat read_image(const std::filesystem::path& path) {
  cv::Mat image;
  std::string fault = decode(read_bytes(path), image);
  if (fault.empty()) fault = to_known_type(image);
  if (!fault.empty()) throw InputError(path.string() + ": " + fault);
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

cv::Mat mat_of(const ImageView& view) {
  const int type = view.format == PixelFormat::kGrey8    ? CV_8UC1
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

}  // namespace adit::io
