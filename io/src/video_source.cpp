#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>
#include <utility>

#include "adit/io/errors.hpp"
#include "frame_sources.hpp"

namespace adit::io {
namespace {

constexpr double kAssumedRate_hz = 30.0;  ///< where a recording does not say

double rate_of(const cv::VideoCapture& capture) {
  const double rate_hz = capture.get(cv::CAP_PROP_FPS);
  return std::isfinite(rate_hz) && rate_hz > 0.1 && rate_hz < 10000.0 ? rate_hz : kAssumedRate_hz;
}

/// No container of moving pictures is plain text; ffmpeg would show some texts as pictures of letters.
bool is_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  char block[4096];
  file.read(block, sizeof block);
  for (std::streamsize i = 0; i < file.gcount(); ++i) {
    const auto c = static_cast<unsigned char>(block[i]);
    if (c < 0x20 && std::strchr("\t\n\r\f", c) == nullptr) return false;
    if (c == 0) return false;
  }
  return true;
}

/// Never cv::CAP_ANY: that would also take numbered images for a video, and be loud about what it tries.
cv::VideoCapture open_capture(const std::filesystem::path& path) {
  cv::VideoCapture capture;
  for (const int reader : {cv::CAP_FFMPEG, cv::CAP_GSTREAMER, cv::CAP_OPENCV_MJPEG}) {
    // It writes on the terminal about files that FFmpeg has refused already.
    if (reader == cv::CAP_OPENCV_MJPEG && cv::videoio_registry::hasBackend(cv::CAP_FFMPEG)) continue;
    try {
      if (capture.open(path.string(), reader)) break;
    } catch (const cv::Exception&) {  // this reader is not built in
    }
  }
  if (capture.isOpened()) capture.set(cv::CAP_PROP_ORIENTATION_AUTO, 0.0);
  return capture;
}

class VideoSource final : public FrameSource {
 public:
  explicit VideoSource(std::filesystem::path path) : path_(std::move(path)) {
    cv::VideoCapture probe = is_text(path_) ? cv::VideoCapture() : open_capture(path_);
    if (!probe.isOpened()) {
      throw InputError(path_.string() + ": neither an image nor a video that can be read, or truncated");
    }
    rate_hz_ = rate_of(probe);
    const double count = probe.get(cv::CAP_PROP_FRAME_COUNT);
    if (count >= 1.0 && count < 1e9) frame_count_ = static_cast<std::int64_t>(count);
    cv::Mat first;
    if (!probe.read(first) || first.empty()) {
      throw InputError(path_.string() + ": no frame of this video can be read; truncated or damaged");
    }
  }

  std::optional<Frame> next() override {
    if (!capture_.isOpened()) capture_ = open_capture(path_);
    Frame frame;
    if (!capture_.read(frame.pixels) || frame.pixels.empty()) {
      capture_.release();
      return std::nullopt;
    }
    frame.source = path_.string();
    frame.index = read_;
    frame.stamp_s = stamp_of(capture_.get(cv::CAP_PROP_POS_MSEC) / 1000.0);
    ++read_;
    return frame;
  }

  [[nodiscard]] std::optional<std::int64_t> frame_count() const override { return frame_count_; }
  [[nodiscard]] bool is_sequence() const override { return true; }
  [[nodiscard]] double rate_hz() const override { return rate_hz_; }

  /// Containers without an index only estimate their length, hence the margin.
  [[nodiscard]] std::string fault() const override {
    if (!frame_count_ || *frame_count_ - read_ <= std::max<std::int64_t>(2, *frame_count_ / 50)) return "";
    return path_.string() + ": the video ends after " + std::to_string(read_) + " of " + std::to_string(*frame_count_) +
           " frames; truncated or damaged";
  }

 private:
  /// The video's own time, where it has one that moves forward.
  double stamp_of(double own_s) {
    const double previous_s = std::exchange(last_stamp_s_, 0.0);
    const bool usable = std::isfinite(own_s) && own_s >= 0.0 && (read_ == 0 || own_s > previous_s);
    last_stamp_s_ = usable ? own_s : (read_ == 0 ? 0.0 : previous_s + 1.0 / rate_hz_);
    return last_stamp_s_;
  }

  std::filesystem::path path_;
  cv::VideoCapture capture_;
  double rate_hz_ = kAssumedRate_hz;
  std::optional<std::int64_t> frame_count_;
  std::int64_t read_ = 0;
  double last_stamp_s_ = 0.0;
};

class CameraSource final : public FrameSource {
 public:
  explicit CameraSource(std::filesystem::path device) : device_(std::move(device)) {
    const int file = ::open(device_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) {
      throw InputError(device_.string() + ": " +
                       (errno == ENOENT ? "no such camera; is it plugged in?" : std::strerror(errno)));
    }
    ::close(file);
    if (!capture_.open(device_.string(), cv::CAP_V4L2)) {
      throw InputError(device_.string() + ": not a camera that gives pictures (Video4Linux)");
    }
  }

  std::optional<Frame> next() override {
    Frame frame;
    if (!capture_.read(frame.pixels) || frame.pixels.empty()) {
      fault_ = device_.string() + ": the camera gave no more frames; unplugged?";
      return std::nullopt;
    }
    const auto now = std::chrono::steady_clock::now();
    if (read_ == 0) begin_ = now;
    frame.source = device_.string();
    frame.index = read_++;
    frame.stamp_s = std::chrono::duration<double>(now - begin_).count();
    return frame;
  }

  [[nodiscard]] std::optional<std::int64_t> frame_count() const override { return std::nullopt; }
  [[nodiscard]] bool is_sequence() const override { return true; }
  [[nodiscard]] double rate_hz() const override { return rate_of(capture_); }
  [[nodiscard]] std::string fault() const override { return fault_; }

 private:
  std::filesystem::path device_;
  cv::VideoCapture capture_;
  std::chrono::steady_clock::time_point begin_;
  std::int64_t read_ = 0;
  std::string fault_;
};

}  // namespace

std::unique_ptr<FrameSource> open_video(const std::filesystem::path& path) {
  return std::make_unique<VideoSource>(path);
}

std::unique_ptr<FrameSource> open_camera(const std::filesystem::path& device) {
  return std::make_unique<CameraSource>(device);
}

}  // namespace adit::io
