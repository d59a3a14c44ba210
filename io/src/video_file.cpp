#include "adit/io/video_file.hpp"

#include <sys/statvfs.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"

namespace adit::io {
namespace {

using Fourcc = int;

std::vector<Fourcc> codecs_for(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".mp4" || extension == ".mkv") {
    return {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')};
  }
  if (extension == ".avi") return {cv::VideoWriter::fourcc('M', 'J', 'P', 'G')};
  throw OutputError(path.string() + ": cannot be written: videos end with .mp4, .mkv or .avi");
}

int even(int side_px) { return side_px + side_px % 2; }

/// The picture fitted into a size, its shape kept, with black bars.
cv::Mat fitted(const cv::Mat& picture, cv::Size size) {
  if (picture.size() == size) return picture;
  const double scale = std::min({1.0 * size.width / picture.cols, 1.0 * size.height / picture.rows});
  cv::Mat canvas = cv::Mat::zeros(size, CV_8UC3);
  // A row or column of padding to an even size is no reason to resample.
  const bool only_padding = even(picture.cols) == size.width && even(picture.rows) == size.height;
  const cv::Size inner = only_padding ? picture.size()
                                      : cv::Size(std::clamp(cvRound(picture.cols * scale), 1, size.width),
                                                 std::clamp(cvRound(picture.rows * scale), 1, size.height));
  const cv::Rect place((size.width - inner.width) / 2, (size.height - inner.height) / 2, inner.width, inner.height);
  cv::Mat inside = canvas(place);
  cv::resize(picture, inside, inner, 0.0, 0.0, cv::INTER_AREA);
  return canvas;
}

bool is_disk_full(const std::filesystem::path& file) {
  // The folder, for an encoder that fails may have removed the file.
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  struct statvfs disk {};
  return ::statvfs(folder.c_str(), &disk) == 0 && disk.f_bavail * disk.f_frsize < (1u << 16);
}

}  // namespace

struct VideoFile::Encoder {
  PendingFile file;
  double rate_hz;
  std::vector<Fourcc> codecs;
  cv::VideoWriter writer;
  cv::Size size;
  std::int64_t frame_count = 0;

  [[noreturn]] void refuse(const std::string& why) const {
    throw OutputError(file.final_path().string() + ": cannot be written: " + why);
  }

  void open(const cv::Mat& first) {
    size = {even(first.cols), even(first.rows)};
    for (const Fourcc codec : codecs) {
      if (writer.open(file.temporary_path().string(), cv::CAP_FFMPEG, codec, rate_hz, size)) return;
    }
    refuse(is_disk_full(file.temporary_path()) ? "No space left on device" : "no encoder for this kind of video");
  }

  /// Encoders do not tell of a full disk: the file is asked instead.
  void check() const {
    cv::VideoCapture reader(file.temporary_path().string(), cv::CAP_FFMPEG);
    const auto found = static_cast<std::int64_t>(reader.isOpened() ? reader.get(cv::CAP_PROP_FRAME_COUNT) : 0.0);
    if (found >= frame_count) return;
    refuse(is_disk_full(file.temporary_path())
               ? "No space left on device"
               : "only " + std::to_string(std::max<std::int64_t>(found, 0)) + " of " + std::to_string(frame_count) +
                     " frames arrived; is the disk full?");
  }
};

VideoFile::VideoFile(const std::filesystem::path& path, double rate_hz)
    : encoder_(new Encoder{PendingFile(path), rate_hz, codecs_for(path), {}, {}, 0}) {}
VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;

void VideoFile::write(const cv::Mat& bgr) {
  if (encoder_->frame_count == 0) encoder_->open(bgr);
  encoder_->writer.write(fitted(bgr, encoder_->size));
  ++encoder_->frame_count;
}

void VideoFile::finish() {
  if (encoder_->frame_count == 0 || !encoder_->writer.isOpened()) return;
  encoder_->writer.release();
  encoder_->check();
  encoder_->file.sync();
}

void VideoFile::commit() {
  if (encoder_->frame_count == 0) return;
  finish();
  encoder_->file.commit();
}

std::int64_t VideoFile::frame_count() const noexcept { return encoder_->frame_count; }

}  // namespace adit::io
