// openings.json while it is being made: what people marked, kept whole on the disk after each change.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace adit::tools {

class MarkFile {
 public:
  /// What the file holds already is kept, also marks of images that are not shown and keys that are not known.
  /// @param path  of openings.json; it need not be there. @param images  that are shown, in this order.
  /// @throws io::InputError when it is there and cannot be read.
  MarkFile(const std::filesystem::path& path, const std::vector<std::filesystem::path>& images);

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::size_t size() const noexcept { return images_.size(); }
  [[nodiscard]] const std::filesystem::path& image(std::size_t i) const { return images_[i]; }
  /// How an image is called in the file: its path from the file's folder.
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_[i]; }
  [[nodiscard]] std::size_t marked_count() const;

  /// [{"name": ..., "openings": [...], "none" or null, "place": "...", "derived_place": "..."}, ...]
  [[nodiscard]] nlohmann::ordered_json state() const;

  /// Takes the marks of one image, {"openings": [...], "none" or null, "place": "..."}, and writes the file.
  /// @param width,height  of the image, px: the file says its size as long as all images have the same.
  /// @return why they are refused, empty when they are taken. @throws io::OutputError
  [[nodiscard]] std::string take(std::size_t i, const nlohmann::ordered_json& marks, int width, int height);

 private:
  [[nodiscard]] nlohmann::ordered_json openings_of(std::size_t i) const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> images_;
  std::vector<std::string> names_;
  nlohmann::ordered_json content_;
};

}  // namespace adit::tools
