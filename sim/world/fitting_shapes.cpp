#include "fitting_shapes.hpp"

#include <cmath>
#include <numbers>

namespace adit::sim {
namespace {

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, RockMaterial material) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.materials.push_back(static_cast<std::uint8_t>(material));
}

}  // namespace

void add_tube(const std::vector<Eigen::Vector3f>& line, float radius_m, int sides, RockMaterial material, Mesh& mesh) {
  if (line.size() < 2) return;
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3f along = (line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]).normalized();
    const Eigen::Vector3f helper = std::abs(along.z()) < 0.9f ? Eigen::Vector3f(Eigen::Vector3f::UnitZ())
                                                              : Eigen::Vector3f(Eigen::Vector3f::UnitX());
    const Eigen::Vector3f u = helper.cross(along).normalized();
    const Eigen::Vector3f v = along.cross(u);
    for (int k = 0; k < sides; ++k) {
      const auto angle = static_cast<float>(2.0 * std::numbers::pi * k / sides);
      mesh.vertices.push_back(line[i] + radius_m * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  const auto rings = static_cast<std::uint32_t>(line.size());
  for (std::uint32_t i = 0; i + 1 < rings; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = base + i * n + k, b = base + i * n + (k + 1) % n;
      add_triangle(mesh, a, b, b + n, material);
      add_triangle(mesh, a, b + n, a + n, material);
    }
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    add_triangle(mesh, base, base + k + 1, base + k, material);
    const std::uint32_t end = base + (rings - 1) * n;
    add_triangle(mesh, end, end + k, end + k + 1, material);
  }
}

void add_stone(const Eigen::Vector3f& place, float size_m, SeededRow& row, Mesh& mesh) {
  // An icosahedron, each corner pushed in or out.
  constexpr float kLong = 0.8507f, kShort = 0.5257f;
  static const Eigen::Vector3f kCorners[12] = {{-kShort, kLong, 0},  {kShort, kLong, 0},   {-kShort, -kLong, 0},
                                               {kShort, -kLong, 0},  {0, -kShort, kLong},  {0, kShort, kLong},
                                               {0, -kShort, -kLong}, {0, kShort, -kLong},  {kLong, 0, -kShort},
                                               {kLong, 0, kShort},   {-kLong, 0, -kShort}, {-kLong, 0, kShort}};
  constexpr std::uint32_t kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const float turn = row.uniform(0.0f, 6.2832f);
  const float wide = row.uniform(0.7f, 1.0f), flat = row.uniform(0.45f, 0.8f);
  for (const Eigen::Vector3f& corner : kCorners) {
    const Eigen::Vector3f lump = corner * (0.5f * size_m * row.uniform(0.7f, 1.15f));
    mesh.vertices.emplace_back(place.x() + std::cos(turn) * lump.x() - wide * std::sin(turn) * lump.y(),
                               place.y() + std::sin(turn) * lump.x() + wide * std::cos(turn) * lump.y(),
                               place.z() + flat * lump.z());
  }
  for (const auto& face : kFaces)
    add_triangle(mesh, base + face[0], base + face[1], base + face[2], RockMaterial::kStone);
}

}  // namespace adit::sim
