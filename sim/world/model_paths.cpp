#include "model_paths.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "adit/sim/world_error.hpp"

namespace adit::sim {
namespace {

namespace fs = std::filesystem;

void append_list(const char* variable, std::vector<std::string>& folders) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  std::istringstream list(value);
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.push_back(folder);
}

/// Names may not climb out of the folder they are looked up in.
void refuse_climbing(const std::string& name, const std::string& uri) {
  const fs::path normal = fs::path(name).lexically_normal();
  if (normal.is_absolute() || (!normal.empty() && *normal.begin() == ".."))
    throw WorldError(fmt::format("{}: leads out of the folder of models; name a model inside it", uri));
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace

ModelPaths::ModelPaths(const std::vector<std::string>& models, const std::string& world_path) : folders_(models) {
  for (const char* variable : {"GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH"})
    append_list(variable, folders_);
  folders_.push_back((fs::path(world_path).parent_path() / "models").string());
}

std::optional<std::string> ModelPaths::found(const std::string& uri, const std::string& beside) const {
  for (const std::string_view scheme : {"model://", "package://"}) {
    if (!uri.starts_with(scheme)) continue;
    const std::string name = uri.substr(scheme.size());
    refuse_climbing(name, uri);
    for (const std::string& folder : folders_)
      if (!name.empty() && is_there(fs::path(folder) / name)) return (fs::path(folder) / name).string();
    return std::nullopt;
  }
  if (uri.empty() || (uri.find("://") != std::string::npos && !uri.starts_with("file://"))) return std::nullopt;
  const fs::path path = uri.starts_with("file://") ? fs::path(uri.substr(7)) : fs::path(uri);
  const fs::path whole = path.is_absolute() ? path : fs::path(beside) / path;
  if (!is_there(whole)) return std::nullopt;
  return whole.string();
}

std::optional<std::string> ModelPaths::model_file(const std::string& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return path;
  tinyxml2::XMLDocument document;
  const fs::path folder(path);
  std::string best = "model.sdf";
  if (document.LoadFile((folder / "model.config").c_str()) == tinyxml2::XML_SUCCESS) {
    const tinyxml2::XMLElement* model = document.FirstChildElement("model");
    std::string best_version;
    for (auto* sdf = model ? model->FirstChildElement("sdf") : nullptr; sdf; sdf = sdf->NextSiblingElement("sdf")) {
      const char* version = sdf->Attribute("version");
      const std::string own = version != nullptr ? version : "";
      if (sdf->GetText() == nullptr || own < best_version || own > "1.9") continue;
      best_version = own;
      best = sdf->GetText();
    }
  }
  refuse_climbing(best, path);
  if (!fs::is_regular_file(folder / best, error)) return std::nullopt;
  return (folder / best).string();
}

}  // namespace adit::sim
