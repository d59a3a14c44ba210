#include "file_uses.hpp"

#include <glob.h>
#include <sys/stat.h>

#include <CLI/Error.hpp>
#include <algorithm>

#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "finder_options.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

fs::path whole_path(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  if (!whole.has_filename()) whole = whole.parent_path();  // "frames/"
  return error ? path : whole;
}

/// "" for what is no file: nothing, standard output, devices and pipes.
std::string identity_of(const fs::path& path) {
  if (path.empty() || path == "-") return "";
  struct stat entry {};
  if (::stat(path.c_str(), &entry) != 0) return whole_path(path).string();
  if (!S_ISREG(entry.st_mode) && !S_ISDIR(entry.st_mode)) return "";
  return std::to_string(entry.st_dev).append(":").append(std::to_string(entry.st_ino));
}

/// What a pattern that no shell has expanded stands for; else the input itself.
std::vector<std::string> expanded(const std::string& input) {
  std::vector<std::string> paths;
  std::error_code error;
  glob_t found{};
  if (!fs::exists(input, error) && ::glob(input.c_str(), GLOB_NOSORT | GLOB_BRACE, nullptr, &found) == 0)
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  if (paths.empty()) paths.push_back(input);
  return paths;
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  const std::string inner = whole_path(path).string(), outer = whole_path(folder).string();
  return inner.size() > outer.size() && inner.starts_with(outer) && (inner[outer.size()] == '/' || outer == "/");
}

[[noreturn]] void refuse(const std::string& name, const std::string& path, const std::string& read_name,
                         const std::string& read_path) {
  throw CLI::ValidationError(
      name, path + " would be written over " + read_path + ", which is read (" + read_name + "); choose another place");
}

}  // namespace

void FileUses::reads(const std::string& name, const fs::path& path) {
  if (std::string id = identity_of(path); !id.empty()) files_.try_emplace(std::move(id), Use{name, path.string()});
}

void FileUses::reads(const FinderOptions& options) {
  reads("--config", options.config_file);
  reads("--camera", options.camera_file);
  reads("--lamp", options.lamp_file);
}

void FileUses::reads_frames(const std::string& name, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs)
    for (const std::string& path : expanded(input)) {
      std::error_code error;
      if (!fs::is_directory(path, error)) {
        reads(name, path);
        const fs::path parent = fs::path(path).parent_path();
        if (io::is_image_name(path))
          folders_of_images_.try_emplace(identity_of(parent.empty() ? fs::path(".") : parent), Use{name, path});
        continue;
      }
      folders_.try_emplace(identity_of(path), Use{name, path});
      for (const auto& entry : fs::directory_iterator(path, error))
        if (io::is_image_name(entry.path())) reads(name, entry.path());
    }
}

void FileUses::reads_all_in(const std::string& name, const fs::path& folder) {
  if (std::string id = identity_of(folder); !id.empty()) trees_.try_emplace(std::move(id), Use{name, folder.string()});
}

void FileUses::writes(const std::string& name, const fs::path& path) {
  const std::string id = identity_of(path);
  if (id.empty()) return;
  if (const auto read = files_.find(id); read != files_.end())
    refuse(name, path.string(), read->second.name, read->second.path);
  std::error_code error;
  for (const auto& [key, tree] : trees_)
    if (fs::is_regular_file(path, error) && lies_in(path, tree.path))
      refuse(name, path.string(), tree.name, "a file of " + tree.path);
  const auto [other, is_new] = written_.try_emplace(id, Use{name, path.string()});
  if (!is_new) throw CLI::ValidationError(name, path.string() + " is taken by " + other->second.name);
}

void FileUses::writes_into(const std::string& name, const fs::path& folder, const std::vector<std::string>& files) {
  if (folder.empty()) return;
  if (const auto read = folders_.find(identity_of(folder)); read != folders_.end())
    throw CLI::ValidationError(name, folder.string() + " is the folder " + read->second.path + " of " +
                                         read->second.name + ": what is written would lie among what is read");
  for (const auto& [id, read] : files_) {
    const std::string file = whole_path(read.path).filename().string();
    if (std::find(files.begin(), files.end(), file) != files.end() && lies_in(read.path, folder))
      refuse(name, (folder / file).string(), read.name, read.path);
  }
  // A link to what is read, under the name of what will be written.
  for (const std::string& file : files)
    if (const auto read = files_.find(identity_of(folder / file)); read != files_.end())
      refuse(name, (folder / file).string(), read->second.name, read->second.path);
}

void FileUses::writes_pictures_into(const std::string& name, const fs::path& folder) {
  writes_into(name, folder, {});
  if (folder.empty()) return;
  if (const auto read = folders_of_images_.find(identity_of(folder)); read != folders_of_images_.end())
    throw CLI::ValidationError(name, folder.string() + " is where " + read->second.path + " of " + read->second.name +
                                         " lies: pictures would lie among what is read");
}

}  // namespace adit::tools
