#include "file_lists.hpp"

#include <glob.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"

namespace adit::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The run of digits at `at`, without leading zeros; `at` moves behind it.
std::string_view take_number(const std::string& text, std::size_t& at) {
  std::size_t first = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  while (first < at && text[first] == '0') ++first;
  return std::string_view(text).substr(first, at - first);
}

void sort_naturally(std::vector<std::filesystem::path>& paths) {
  std::sort(paths.begin(), paths.end(),
            [](const auto& a, const auto& b) { return natural_less(a.string(), b.string()); });
}

bool is_video_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array kKnown{".mp4",  ".avi", ".mkv", ".mov", ".webm", ".m4v",  ".mpg",
                                     ".mpeg", ".ts",  ".ogv", ".wmv", ".flv",  ".mjpg", ".mjpeg"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string_view x = take_number(a, i);
      const std::string_view y = take_number(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
    ++i;
    ++j;
  }
  if (i < a.size() || j < b.size()) return i == a.size();
  return a < b;  // 01 and 1: some order, always the same
}

std::vector<std::filesystem::path> images_of_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> images;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (path.filename().string().front() == '.' || !is_image_name(path)) continue;
    std::error_code ignored;
    if (!entry->is_directory(ignored)) images.push_back(path);
  }
  if (error) throw InputError(folder.string() + ": cannot be listed: " + error.message());
  if (images.empty()) {
    throw InputError(folder.string() +
                     ": no images in this folder (png, jpg, bmp, tif, pgm, ppm; subfolders are not "
                     "searched)");
  }
  sort_naturally(images);
  return images;
}

bool is_pattern(const std::string& text) { return text.find_first_of("*?[") != std::string::npos; }

std::vector<std::filesystem::path> matches_of(const std::string& pattern) {
  glob_t found{};
  const int outcome = ::glob(pattern.c_str(), GLOB_NOSORT | GLOB_BRACE, nullptr, &found);
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; outcome == 0 && i < found.gl_pathc; ++i) {
    std::filesystem::path path = found.gl_pathv[i];
    std::error_code ignored;
    if (is_image_name(path) || is_video_name(path) || std::filesystem::is_directory(path, ignored)) {
      paths.push_back(std::move(path));
    }
  }
  ::globfree(&found);
  if (paths.empty()) {
    throw InputError(pattern + (outcome == 0 ? ": no image, video or folder matches" : ": no file matches"));
  }
  sort_naturally(paths);
  return paths;
}

}  // namespace adit::io
