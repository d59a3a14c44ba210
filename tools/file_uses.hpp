// What a command reads and what it will write: nothing that is read is ever written over.
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace adit::tools {

struct FinderOptions;

/// Files are told apart by device and inode where they are there, by their canonical path where they are not yet: a
/// link or "./a.png" is a.png. Empty paths, "-", devices and pipes are no files and are passed over. All that is read
/// is named before what is written; each write is checked as it is named, so before it is opened.
class FileUses {
 public:
  /// @param name  as people know it: "--config", "IMAGE"
  void reads(const std::string& name, const std::filesystem::path& path);
  /// What --config, --camera and --lamp name.
  void reads(const FinderOptions& options);
  /// Images, folders of images, patterns, videos, bags. A folder stands for the images in it.
  void reads_frames(const std::string& name, const std::vector<std::string>& inputs);
  /// All in a folder and beneath it, such as meshes that a world file names.
  void reads_all_in(const std::string& name, const std::filesystem::path& folder);

  /// @throws CLI::ValidationError "--csv: a.png would be written over a.png, which is read (INPUT); choose..."
  void writes(const std::string& name, const std::filesystem::path& path);
  /// A folder that gets files of these names, in it or in folders beneath it. It may be no folder that is read.
  /// @throws CLI::ValidationError
  void writes_into(const std::string& name, const std::filesystem::path& folder, const std::vector<std::string>& files);
  /// A folder that gets pictures: beside images that are read, they would be taken for inputs the next time.
  /// @throws CLI::ValidationError
  void writes_pictures_into(const std::string& name, const std::filesystem::path& folder);

 private:
  struct Use {
    std::string name;
    std::string path;  ///< as given
  };
  using Uses = std::unordered_map<std::string, Use>;  ///< by identity

  Uses files_, folders_, folders_of_images_, trees_, written_;
};

}  // namespace adit::tools
