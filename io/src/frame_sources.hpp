// The kinds of sources behind open_sources().
#pragma once

#include "adit/io/frame_source.hpp"

namespace adit::io {

/// Image files in the order given. They are opened one by one, by load_pixels().
class ImageSource final : public FrameSource {
 public:
  ImageSource(std::vector<std::filesystem::path> files, const SourceOptions& options);
  std::optional<Frame> next() override;
  [[nodiscard]] std::optional<std::int64_t> frame_count() const override;
  [[nodiscard]] bool is_sequence() const override { return options_.images_are_sequence; }
  [[nodiscard]] double rate_hz() const override { return options_.images_hz; }

 private:
  std::vector<std::filesystem::path> files_;
  SourceOptions options_;
  std::size_t next_ = 0;
};

/// Opens a video file and reads its first frame, to be sure of it. @throws InputError
[[nodiscard]] std::unique_ptr<FrameSource> open_video(const std::filesystem::path& path);

/// @param device  /dev/videoN. @throws InputError
[[nodiscard]] std::unique_ptr<FrameSource> open_camera(const std::filesystem::path& device);

}  // namespace adit::io
