// Where `model://NAME/...` lies on disk.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace adit::sim {

class ModelPaths {
 public:
  /// @param world_path  the file that is read; `models` beside it is searched last.
  ModelPaths(const std::vector<std::string>& models, const std::string& world_path);

  /// A file or folder that exists, or empty. @param beside  folder of the file that names it, for relative names.
  /// @throws WorldError for a name that leads out of its folder.
  [[nodiscard]] std::optional<std::string> found(const std::string& uri, const std::string& beside) const;

  /// The SDF file of a model's folder (from its model.config, the newest version that libsdformat knows), or the path
  /// itself where it is a file. Empty when there is none.
  [[nodiscard]] static std::optional<std::string> model_file(const std::string& path);

 private:
  std::vector<std::string> folders_;
};

}  // namespace adit::sim
