// Image files that libraries read half and call whole: JPEG and PNG.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace adit::io {

using Bytes = std::vector<unsigned char>;

[[nodiscard]] bool is_jpeg(const Bytes& bytes);
[[nodiscard]] bool is_png(const Bytes& bytes);

/// Decodes a JPEG to CV_8UC1 or CV_8UC3 (BGR). Returns why not, "" when it is whole: a file that ends early or whose
/// codes are damaged is refused, where cv::imdecode fills the rest with grey.
[[nodiscard]] std::string decode_jpeg(const Bytes& bytes, cv::Mat& image);

/// Walks a PNG's chunks and their checksums. Returns why it is refused, "" when it is whole; `plain` is then the same
/// picture without the chunks that are not needed to read it (profiles, text), so that libpng has nothing to complain
/// about on stderr.
[[nodiscard]] std::string check_png(const Bytes& bytes, Bytes& plain);

}  // namespace adit::io
