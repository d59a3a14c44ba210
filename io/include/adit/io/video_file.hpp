// Videos on disk that are whole when they appear.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>

namespace adit::io {

/// Writes .mp4 and .mkv (H.264 where there is an encoder, else MPEG-4 part 2) or .avi (Motion JPEG).
class VideoFile {
 public:
  /// @throws OutputError when the extension is another, or the place cannot be written to.
  VideoFile(const std::filesystem::path& path, double rate_hz);
  ~VideoFile();
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) = delete;

  /// Adds a picture, 8-bit BGR. The first one gives the size (made even by black edges); others are fitted into it,
  /// with black bars. @throws OutputError when no encoder can be had.
  void write(const cv::Mat& bgr);

  /// Closes the file and looks whether all its frames can be found again. @throws OutputError
  void finish();
  /// finish(), if that was not done, and the final name. A video without a frame does not appear at all.
  /// @throws OutputError
  void commit();

  [[nodiscard]] std::int64_t frame_count() const noexcept;

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace adit::io
