// Where frames come from: images, folders, globs, video files, cameras.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace adit::io {

/// One frame, and where and when it was taken.
struct Frame {
  std::string source;          ///< the image file, the video file or the device
  std::int64_t index = 0;      ///< counted from 0 within its FrameSource
  double stamp_s = 0.0;        ///< images: index / images_hz; videos: their own time; cameras: since their first frame
  cv::Mat pixels;              ///< of a type that view_of() takes; empty before load_pixels() and when unreadable
  std::filesystem::path file;  ///< what load_pixels() reads; empty when the pixels came with the frame
  std::string fault;           ///< why the frame is unreadable, with the file's name; empty when it is not
};

/// Reads the pixels of a frame that came without: images are read where they are judged, by many threads at once.
/// A file that cannot be read leaves the pixels empty and says why in `fault`.
void load_pixels(Frame& frame);

/// A row of frames with one clock.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// The next frame, or nothing at the end.
  virtual std::optional<Frame> next() = 0;
  /// Frames in all, where that is known beforehand. Videos say it themselves and may be wrong.
  [[nodiscard]] virtual std::optional<std::int64_t> frame_count() const = 0;
  /// Do the frames follow each other in time (videos, cameras), so that steering may remember?
  [[nodiscard]] virtual bool is_sequence() const = 0;
  /// Frames per second.
  [[nodiscard]] virtual double rate_hz() const = 0;
  /// Why the end came early (a truncated video, a camera unplugged), with the file's name; empty when it did not.
  [[nodiscard]] virtual std::string fault() const { return ""; }
};

struct SourceOptions {
  double images_hz = 30.0;           ///< > 0; the clock of images and folders
  bool images_are_sequence = false;  ///< images and folders are frames of one recording, in natural order
};

/// Turns the arguments of a person into sources, in the order given. Images named one after the other make one source;
/// so does each folder (its images in natural order: 2 before 10; no subfolders, no hidden files). Patterns with *, ?
/// or [] that no shell has expanded are expanded here. /dev/videoN is a camera. Everything else is a video.
/// EXIF rotation and the rotation flag of videos are ignored: a robot's camera does not turn.
/// @throws InputError naming the argument that is missing, empty, without images, or no image and no video.
[[nodiscard]] std::vector<std::unique_ptr<FrameSource>> open_sources(const std::vector<std::string>& inputs,
                                                                     const SourceOptions& options);

}  // namespace adit::io
