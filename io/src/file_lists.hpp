// Folders and patterns as lists of files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace adit::io {

/// Natural order: runs of digits compare as numbers (frame2 before frame10), everything else as bytes.
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

/// The images of a folder in natural order; no subfolders, no hidden files.
/// @throws InputError when it cannot be listed or holds none.
[[nodiscard]] std::vector<std::filesystem::path> images_of_folder(const std::filesystem::path& folder);

/// Has it one of * ? [ ?
[[nodiscard]] bool is_pattern(const std::string& text);

/// What a pattern stands for, in natural order: images, videos and folders. Other files are passed over, as a folder
/// passes them over. @throws InputError when nothing matches.
[[nodiscard]] std::vector<std::filesystem::path> matches_of(const std::string& pattern);

}  // namespace adit::io
