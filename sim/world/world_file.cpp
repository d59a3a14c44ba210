#include "adit/sim/world_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "adit/sim/world_error.hpp"
#include "mesh_reader.hpp"
#include "model_paths.hpp"
#include "sdf_file.hpp"
#include "tile_network.hpp"

namespace adit::sim {
namespace {

namespace fs = std::filesystem;

/// Deeper nesting of files than this is taken for a mistake.
constexpr std::size_t kDepthMax = 20;
/// More pieces than this are taken for a mistake: a file that includes ten others that include ten others ...
constexpr std::size_t kPieceMax = 50'000;
/// Material indices are bytes.
constexpr std::size_t kMaterialMax = 250;

class WorldReader {
 public:
  WorldReader(const std::string& path, const WorldFileConfig& config)
      : path_(path),
        own_path_(fs::absolute(path).lexically_normal().string()),
        config_(config),
        paths_(config.models, path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    if (!error) own_path_ = canonical.string();
  }

  World read() {
    const SdfFile& file = sdf_of(path_);
    world_.name = file.name;
    place(path_, file, file.is_model ? file.model_pose : Eigen::Affine3d::Identity());
    if (world_.mesh.triangles.empty())
      throw WorldError(fmt::format(
          "{}: no faces in it{}", path_,
          missing_.empty() ? ""
                           : "; models not found: " + list_of_missing() + "; say where they are with --models DIR"));
    if (!missing_.empty()) world_.notes.insert(world_.notes.begin(), "models not found: " + list_of_missing());
    if (!config_.world_lights && lamps_seen_ > 0)
      world_.notes.push_back(fmt::format("lights of the file passed over: {}", lamps_seen_));
    add_tile_network(tiles_, world_);
    return std::move(world_);
  }

 private:
  const SdfFile& sdf_of(const std::string& path) {
    const auto [found, is_new] = files_.try_emplace(path);
    if (is_new) {
      try {
        found->second = read_sdf_file(path, config_.geometry);
      } catch (...) {
        files_.erase(found);
        throw;
      }
      for (const std::string& note : found->second.notes) world_.notes.push_back(note);
    }
    return found->second;
  }

  void place(const std::string& path, const SdfFile& file, const Eigen::Affine3d& pose) {
    if (open_.size() >= kDepthMax) throw WorldError(fmt::format("{}: includes nested deeper than {}", path, kDepthMax));
    open_.push_back(path);
    const std::string beside = fs::path(path).parent_path().string();
    for (const SdfShape& shape : file.shapes) add_shape(shape, beside, pose);
    for (const WorldLamp& lamp : file.lamps) add_lamp(lamp, pose);
    for (const SdfInclusion& inclusion : file.inclusions) include(inclusion, beside, pose);
    open_.pop_back();
  }

  void count_piece() {
    if (++pieces_ > kPieceMax) throw WorldError(fmt::format("{}: more than {} shapes and includes", path_, kPieceMax));
  }

  /// The file that an include names, looked for on disk only once.
  const std::optional<std::string>& file_of(const std::string& uri, const std::string& beside) {
    const auto [found, is_new] = included_.try_emplace({uri, beside});
    if (!is_new) return found->second;
    const auto folder = paths_.found(uri, beside);
    const auto path = folder ? ModelPaths::model_file(*folder) : std::nullopt;
    if (path) found->second = fs::weakly_canonical(*path).string();
    return found->second;
  }

  void include(const SdfInclusion& inclusion, const std::string& beside, const Eigen::Affine3d& pose) {
    count_piece();
    const std::optional<std::string>& file_path = file_of(inclusion.uri, beside);
    if (!file_path) {
      ++missing_[inclusion.uri];
      return;
    }
    const std::string& path = *file_path;
    if (std::find(open_.begin(), open_.end(), path) != open_.end() || path == own_path_)
      throw WorldError(
          fmt::format("{}: includes {}, which leads back to itself; break the circle", open_.back(), inclusion.uri));
    const SdfFile& file = sdf_of(path);
    const Eigen::Affine3d placed = pose * (inclusion.has_pose ? inclusion.pose : inclusion.pose * file.model_pose);
    tiles_.push_back({file.name, placed});
    place(path, file, placed);
  }

  void add_lamp(WorldLamp lamp, const Eigen::Affine3d& pose) {
    ++lamps_seen_;
    if (!config_.world_lights) return;
    lamp.place = (pose * lamp.place.cast<double>()).cast<float>();
    lamp.axis = (pose.linear() * lamp.axis.cast<double>()).cast<float>();
    world_.lamps.push_back(lamp);
  }

  void add_shape(const SdfShape& shape, const std::string& beside, const Eigen::Affine3d& pose) {
    count_piece();
    if (shape.mesh_uri.empty()) {
      const std::string name = shape.has_colour ? fmt::format("shape_{:.2f}", shape.albedo) : "shape";
      append(shape.made, {material_of(unknown_rock(name), shape)}, pose * shape.pose);
      return;
    }
    const LoadedMesh* loaded = mesh_of(shape, beside);
    if (loaded == nullptr) return;
    std::vector<std::uint8_t> materials = loaded->materials;
    // The visual's own colour counts where the mesh is one material and has none of its own.
    if (shape.has_colour && loaded->part.materials.size() == 1)
      materials = {material_of(loaded->part.materials.front(), shape)};
    append(loaded->part.mesh, materials, pose * shape.pose);
  }

  struct LoadedMesh {
    MeshPart part;
    std::vector<std::uint8_t> materials;  ///< index in the world for each of the part's
  };

  const LoadedMesh* mesh_of(const SdfShape& shape, const std::string& beside) {
    const std::string wanted =
        shape.mesh_uri + '\n' + beside + '\n' + shape.submesh + (shape.centre_submesh ? "\nc" : "");
    const auto [known, is_unknown] = wanted_meshes_.try_emplace(wanted, nullptr);
    if (!is_unknown) {
      if (known->second == nullptr) ++missing_[shape.mesh_uri];
      return known->second;
    }
    const auto path = paths_.found(shape.mesh_uri, beside);
    if (!path) {
      ++missing_[shape.mesh_uri];
      return nullptr;
    }
    return known->second = load_once(*path, shape);
  }

  const LoadedMesh* load_once(const std::string& path, const SdfShape& shape) {
    const std::string key =
        fs::weakly_canonical(path).string() + '\n' + shape.submesh + (shape.centre_submesh ? "\nc" : "");
    const auto [found, is_new] = meshes_.try_emplace(key);
    if (!is_new) return found->second.get();
    auto loaded = std::make_unique<LoadedMesh>();
    loaded->part = read_mesh_part(path, {}, true, shape.submesh);
    if (shape.centre_submesh) centre(loaded->part.mesh);
    for (const Material& material : loaded->part.materials) loaded->materials.push_back(index_of(material));
    found->second = std::move(loaded);
    return found->second.get();
  }

  static void centre(Mesh& mesh) {
    Eigen::Vector3f low = mesh.vertices.front(), high = low;
    for (const Eigen::Vector3f& v : mesh.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    for (Eigen::Vector3f& v : mesh.vertices) v -= 0.5f * (low + high);
  }

  std::uint8_t material_of(Material material, const SdfShape& shape) {
    if (shape.has_colour) {
      material.albedo = shape.albedo;
      material.tint = shape.tint;
    }
    return index_of(material);
  }

  /// Materials that look alike are one.
  std::uint8_t index_of(const Material& material) {
    auto& all = world_.materials;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Material& other) {
      return other.name == material.name && other.albedo == material.albedo && other.tint == material.tint;
    });
    if (found != all.end()) return static_cast<std::uint8_t>(found - all.begin());
    if (all.size() >= kMaterialMax) return 0;
    all.push_back(material);
    return static_cast<std::uint8_t>(all.size() - 1);
  }

  void append(const Mesh& from, const std::vector<std::uint8_t>& materials, const Eigen::Affine3d& pose) {
    Mesh& to = world_.mesh;
    if (to.triangles.size() + from.triangles.size() > kTriangleMax)
      throw WorldError(
          fmt::format("{}: more than {} triangles; leave models out or simplify their meshes", path_, kTriangleMax));
    if (!pose.matrix().allFinite() || pose.translation().norm() > 1e6)
      throw WorldError(fmt::format("{}: a pose is not finite or further away than 1000 km", path_));
    const auto base = static_cast<std::uint32_t>(to.vertices.size());
    const bool is_mirrored = pose.linear().determinant() < 0.0;
    for (const Eigen::Vector3f& v : from.vertices) to.vertices.push_back((pose * v.cast<double>()).cast<float>());
    for (std::size_t i = 0; i < from.triangles.size(); ++i) {
      Eigen::Matrix<std::uint32_t, 3, 1> triangle = from.triangles[i].array() + base;
      if (is_mirrored) std::swap(triangle[1], triangle[2]);
      to.triangles.push_back(triangle);
      to.materials.push_back(materials[std::min<std::size_t>(from.materials[i], materials.size() - 1)]);
    }
  }

  std::string list_of_missing() const {
    std::string list;
    for (const auto& [uri, count] : missing_)
      list += (list.empty() ? "" : ", ") + uri + (count > 1 ? fmt::format(" ({} times)", count) : "");
    return list;
  }

  std::string path_;
  std::string own_path_;  ///< the same without links and dots
  const WorldFileConfig& config_;
  ModelPaths paths_;
  World world_;
  std::vector<std::string> open_;  ///< files being placed, outermost first
  std::map<std::string, SdfFile> files_;
  std::map<std::string, std::unique_ptr<LoadedMesh>> meshes_;  ///< by file
  std::map<std::string, const LoadedMesh*> wanted_meshes_;     ///< by name and folder; null: not found
  std::map<std::pair<std::string, std::string>, std::optional<std::string>> included_;
  std::map<std::string, int> missing_;
  std::vector<PlacedTile> tiles_;
  std::size_t pieces_ = 0;
  int lamps_seen_ = 0;
};

}  // namespace

World load_world(const std::string& path, const WorldFileConfig& config) { return WorldReader(path, config).read(); }

}  // namespace adit::sim
