#include "adit/io/frame_source.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "file_lists.hpp"
#include "frame_sources.hpp"
#include "text_file.hpp"

namespace adit::io {
namespace {

/// Is this an image by its first bytes? For files whose name does not say so.
bool begins_like_image(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  char begin[8] = "";
  file.read(begin, sizeof begin);
  const std::string_view head(begin, static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  if (head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff")) return true;
  if (head.starts_with(std::string_view("II*\0", 4)) || head.starts_with(std::string_view("MM\0*", 4))) return true;
  return head.size() > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '6' && (head[2] == '\n' || head[2] == ' ');
}

bool is_camera_name(const std::string& text) {
  constexpr std::string_view kPrefix = "/dev/video";
  return text.starts_with(kPrefix) && text.size() > kPrefix.size() &&
         text.find_first_not_of("0123456789", kPrefix.size()) == std::string::npos;
}

/// Collects sources; images that follow each other wait to become one.
class Collector {
 public:
  explicit Collector(const SourceOptions& options) : options_(options) {}

  void add(const std::string& input) {
    std::error_code error;
    const std::filesystem::path path = input;
    if (is_camera_name(input)) {
      add_source(open_camera(path));
    } else if (std::filesystem::is_directory(path, error)) {
      add_source(std::make_unique<ImageSource>(images_of_folder(path), options_));
    } else if (is_pattern(input) && !std::filesystem::exists(path, error)) {
      for (const std::filesystem::path& match : matches_of(input)) add(match.string());
    } else {
      add_file(path);
    }
  }

  std::vector<std::unique_ptr<FrameSource>> take() {
    gather_images();
    return std::move(sources_);
  }

 private:
  void add_file(const std::filesystem::path& path) {
    const std::string fault = fault_of_file(path);
    const bool is_image = is_image_name(path);
    // An empty image among others is an unreadable frame; alone it is found out when it is read.
    if (!fault.empty() && !(is_image && fault == kEmptyFile)) throw InputError(path.string() + ": " + fault);
    if (is_image || begins_like_image(path)) {
      images_.push_back(path);
    } else {
      add_source(open_video(path));
    }
  }

  void add_source(std::unique_ptr<FrameSource> source) {
    gather_images();
    sources_.push_back(std::move(source));
  }

  void gather_images() {
    if (images_.empty()) return;
    sources_.push_back(std::make_unique<ImageSource>(std::exchange(images_, {}), options_));
  }

  SourceOptions options_;
  std::vector<std::filesystem::path> images_;
  std::vector<std::unique_ptr<FrameSource>> sources_;
};

}  // namespace

void load_pixels(Frame& frame) {
  if (frame.file.empty()) return;
  try {
    frame.pixels = read_image(frame.file);
  } catch (const InputError& e) {
    frame.fault = e.what();
  }
}

ImageSource::ImageSource(std::vector<std::filesystem::path> files, const SourceOptions& options)
    : files_(std::move(files)), options_(options) {}

std::optional<Frame> ImageSource::next() {
  if (next_ == files_.size()) return std::nullopt;
  Frame frame;
  frame.file = files_[next_];
  frame.source = frame.file.string();
  frame.index = static_cast<std::int64_t>(next_);
  frame.stamp_s = static_cast<double>(next_) / options_.images_hz;
  ++next_;
  return frame;
}

std::optional<std::int64_t> ImageSource::frame_count() const { return static_cast<std::int64_t>(files_.size()); }

std::vector<std::unique_ptr<FrameSource>> open_sources(const std::vector<std::string>& inputs,
                                                       const SourceOptions& options) {
  Collector collector(options);
  for (const std::string& input : inputs) collector.add(input);
  return collector.take();
}

}  // namespace adit::io
