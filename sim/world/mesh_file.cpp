#include "adit/sim/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>

#include "adit/sim/world_error.hpp"
#include "mesh_checks.hpp"
#include "mesh_reader.hpp"

namespace adit::sim {
namespace {

namespace fs = std::filesystem;

/// World::Material indices are bytes.
constexpr unsigned kMaterialMax = 250;

Eigen::Matrix4d matrix_of(const aiMatrix4x4& m) {
  Eigen::Matrix4d result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return result;
}

/// Turns the file's axes so that z points up.
Eigen::Matrix4d turned(MeshUp up) {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  if (up == MeshUp::kY) result.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == MeshUp::kX) result.topLeftCorner<3, 3>() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return result;
}

class AssimpReader {
 public:
  AssimpReader(const std::string& path, const MeshFileConfig& config, bool is_gazebo, const std::string& submesh)
      : path_(path), submesh_(submesh) {
    const bool is_collada = extension_of(path) == ".dae";
    // Assimp turns Collada to y up unless told not to. Gazebo takes the numbers as they stand.
    const bool keep_axes = is_gazebo || config.mesh_up != MeshUp::kFile;
    importer_.SetPropertyInteger(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, keep_axes ? 1 : 0);
    // Points and lines are not faces.
    importer_.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    MeshUp up = config.mesh_up;
    if (is_gazebo) up = MeshUp::kZ;
    if (up == MeshUp::kFile) up = is_collada ? MeshUp::kY : MeshUp::kZ;
    to_world_ = turned(up);
    to_world_.topLeftCorner<3, 3>() *= config.mesh_scale;
  }

  MeshPart read() {
    const aiScene* scene = importer_.ReadFile(path_, aiProcess_Triangulate | aiProcess_SortByPType);
    if (scene == nullptr || scene->mRootNode == nullptr) refuse(path_, reason());
    std::uint64_t faces = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) faces += scene->mMeshes[i]->mNumFaces;
    refuse_if_too_many(path_, faces);
    add_materials(*scene);
    add_node(*scene, *scene->mRootNode, to_world_, submesh_.empty());
    if (part_.mesh.triangles.empty())
      refuse(path_, submesh_.empty() ? "no faces in it; a mesh of triangles or polygons is wanted"
                                     : fmt::format("no faces in its submesh '{}'", submesh_));
    return std::move(part_);
  }

 private:
  /// Assimp's own words, on one line.
  std::string reason() const {
    std::string text = importer_.GetErrorString();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return "cannot be read as a mesh: " + (text.empty() ? "broken file" : text) +
           " Is it whole? Export or copy it again.";
  }

  void add_materials(const aiScene& scene) {
    for (unsigned i = 0; i < std::min(scene.mNumMaterials, kMaterialMax); ++i) {
      const aiMaterial& from = *scene.mMaterials[i];
      Material material = unknown_rock(from.GetName().C_Str());
      aiColor3D colour(0.0f, 0.0f, 0.0f);
      // A texture is not read: what it shows is taken for rock.
      const bool is_textured = from.GetTextureCount(aiTextureType_DIFFUSE) > 0;
      if (!is_textured && from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) paint(colour, material);
      part_.materials.push_back(material);
    }
    if (part_.materials.empty()) part_.materials.push_back(unknown_rock("rock"));
  }

  static void paint(const aiColor3D& colour, Material& material) {
    const float mean = (colour.r + colour.g + colour.b) / 3.0f;
    if (!(mean > 0.02f && mean < 0.95f)) return;  // black and white are what exporters write who know nothing
    material.albedo = std::min(mean, 0.8f);
    material.tint = Eigen::Vector3f(colour.r, colour.g, colour.b) / mean;
  }

  void add_node(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent, bool is_wanted) {
    const Eigen::Matrix4d pose = parent * matrix_of(node.mTransformation);
    const bool take = is_wanted || submesh_ == node.mName.C_Str();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
      if (take || submesh_ == mesh.mName.C_Str()) add_mesh(mesh, pose);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], pose, take);
  }

  void add_mesh(const aiMesh& from, const Eigen::Matrix4d& pose) {
    Mesh& to = part_.mesh;
    const auto base = static_cast<std::uint32_t>(to.vertices.size());
    refuse_if_too_many(path_, to.triangles.size() + from.mNumFaces);
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& v = from.mVertices[i];
      const Eigen::Vector4d place = pose * Eigen::Vector4d(v.x, v.y, v.z, 1.0);
      if (!(place.array().abs() < 1e6).all())
        refuse(path_, fmt::format("vertex {} is ({}, {}, {}): not finite, or further than 1000 km; mend the file or "
                                  "its scale",
                                  i, v.x, v.y, v.z));
      to.vertices.push_back(place.head<3>().cast<float>());
    }
    // A mirror turns faces inside out.
    const bool is_mirrored = pose.topLeftCorner<3, 3>().determinant() < 0.0;
    const unsigned material =
        std::min<unsigned>(from.mMaterialIndex, static_cast<unsigned>(part_.materials.size()) - 1);
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices != 3) continue;
      for (unsigned k = 0; k < 3; ++k)
        if (face.mIndices[k] >= from.mNumVertices)
          refuse(path_, fmt::format("face {} names a vertex that is not there", i));
      to.triangles.emplace_back(base + face.mIndices[0], base + face.mIndices[is_mirrored ? 2 : 1],
                                base + face.mIndices[is_mirrored ? 1 : 2]);
      to.materials.push_back(static_cast<std::uint8_t>(material));
    }
  }

  const std::string& path_;
  const std::string& submesh_;
  Assimp::Importer importer_;
  Eigen::Matrix4d to_world_;
  MeshPart part_;
};

}  // namespace

Material unknown_rock(const std::string& name) {
  Material material;
  material.name = name;
  material.albedo_log_sigma = 0.3f;
  return material;
}

MeshPart read_mesh_part(const std::string& path, const MeshFileConfig& config, bool is_gazebo,
                        const std::string& submesh) {
  check_mesh_file(path);
  return AssimpReader(path, config, is_gazebo, submesh).read();
}

World load_mesh(const std::string& path, const MeshFileConfig& config) {
  if (!(config.mesh_scale >= 1e-6 && config.mesh_scale <= 1e6))
    throw WorldError(fmt::format("mesh_scale is {}; give 0.000001 to 1000000", config.mesh_scale));
  MeshPart part = read_mesh_part(path, config, false);
  World world;
  world.name = fs::path(path).stem().string();
  world.mesh = std::move(part.mesh);
  world.materials = std::move(part.materials);
  return world;
}

}  // namespace adit::sim
