// Images on disk.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "adit/image.hpp"

namespace adit::io {

/// Is this a file name that read_image() is made for (png, jpg, jpeg, bmp, tif, tiff, pgm, ppm; any case)?
[[nodiscard]] bool is_image_name(const std::filesystem::path& path);

/// Reads png, jpg, bmp, tif, pgm and ppm as they are: CV_8UC1, CV_8UC3 (BGR), CV_8UC4 (BGRA) or CV_16UC1.
/// 16-bit colour comes as 8-bit colour. EXIF rotation is ignored: a robot's camera does not turn.
/// @throws InputError when the file is missing, empty, truncated or no image: never a picture that is half grey.
[[nodiscard]] cv::Mat read_image(const std::filesystem::path& path);

/// Wraps the pixels of a Mat of one of the types above (BGR order). An ImageView without data for any other type.
[[nodiscard]] ImageView view_of(const cv::Mat& image) noexcept;

/// The other way round: shares the pixels where their order is OpenCV's, and turns a copy of RGB and RGBA to it.
/// @param view  of any format, with data; packed (ImageView::is_packed).
[[nodiscard]] cv::Mat mat_of(const ImageView& view);

}  // namespace adit::io
