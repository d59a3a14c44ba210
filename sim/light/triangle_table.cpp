// What a triangle is to the shading loops. Normals and reflectance stand at its corners, so that neither jumps from
// triangle to triangle.
#include <cstring>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;

/// Triangles about each vertex, one list after the other.
struct Around {
  std::vector<std::uint32_t> first;  ///< of each vertex, and the end
  std::vector<std::uint32_t> triangles;
};

Around around_of(const Mesh& mesh) {
  Around around;
  around.first.assign(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++around.first[t[k] + 1];
  for (std::size_t i = 1; i < around.first.size(); ++i) around.first[i] += around.first[i - 1];
  around.triangles.resize(around.first.back());
  std::vector<std::uint32_t> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) around.triangles[next[mesh.triangles[i][k]]++] = static_cast<std::uint32_t>(i);
  return around;
}

void place_corners(TriangleRow& row, const Mesh& mesh, std::size_t triangle, const Vector3f& normal) {
  const auto& t = mesh.triangles[triangle];
  const Vector3f first = mesh.vertices[t[0]];
  const Vector3f sides[2] = {mesh.vertices[t[1]] - first, mesh.vertices[t[2]] - first};
  for (int c = 0; c < 3; ++c) {
    row.corner[c] = first[c];
    row.side_1[c] = sides[0][c];
    row.side_2[c] = sides[1][c];
    row.normal[c] = normal[c];
  }
  row.material = mesh.materials[triangle];
}

}  // namespace

/// The mean over the triangles that meet at a corner and are not turned from this one by more than 50 deg, weighted by
/// area for normals: edges of props and pipes stay sharp, rock gets round, and a wet place has no edge of teeth.
std::vector<TriangleRow> triangle_table_of(const World& world) {
  constexpr float kCosine = 0.64f;
  const Mesh& mesh = world.mesh;
  const Around around = around_of(mesh);
  std::vector<Vector3f> flat(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    flat[i] = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  }
  std::vector<TriangleRow> table(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const float length = flat[i].norm();
    TriangleRow& row = table[i];
    place_corners(row, mesh, i, flat[i]);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      Vector3f normal = Vector3f::Zero(), reflectance = Vector3f::Zero();
      float count = 0.0f;
      for (std::uint32_t a = around.first[vertex]; a < around.first[vertex + 1]; ++a) {
        const std::uint32_t triangle = around.triangles[a];
        const bool smooth = flat[triangle].dot(flat[i]) >= kCosine * length * flat[triangle].norm();
        if (!smooth && triangle != i) continue;
        const Material& m = world.materials[mesh.materials[triangle]];
        if (smooth) normal += flat[triangle];
        reflectance += Vector3f(m.albedo, m.specular, m.facet_slope);
        count += 1.0f;
      }
      if (normal.squaredNorm() < 1e-20f) normal = Vector3f::UnitZ();
      normal.normalize();
      reflectance /= count;
      for (int c = 0; c < 3; ++c) {
        row.normals[3 * k + c] = normal[c];
        row.reflectance[3 * k + c] = reflectance[c];
      }
    }
  }
  return table;
}

}  // namespace adit::sim
