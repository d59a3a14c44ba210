#include <cmath>
#include <numbers>

#include "sdf_file.hpp"

namespace adit::sim {
namespace {

constexpr int kSides = 24;

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.materials.push_back(0);
}

float angle_of(int side) { return static_cast<float>(2.0 * std::numbers::pi * side / kSides); }

}  // namespace

Mesh box_mesh(const Eigen::Vector3d& size) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back(
        (0.5 * size.cwiseProduct(Eigen::Vector3d((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1)))
            .cast<float>());
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    add_triangle(mesh, face[0], face[1], face[2]);
    add_triangle(mesh, face[0], face[2], face[3]);
  }
  return mesh;
}

Mesh cylinder_mesh(double radius_m, double length_m) {
  Mesh mesh;
  const auto radius = static_cast<float>(radius_m);
  const auto half = static_cast<float>(0.5 * length_m);
  mesh.vertices = {{0.0f, 0.0f, -half}, {0.0f, 0.0f, half}};
  for (int i = 0; i < kSides; ++i)
    for (const float z : {-half, half})
      mesh.vertices.emplace_back(radius * std::cos(angle_of(i)), radius * std::sin(angle_of(i)), z);
  for (int i = 0; i < kSides; ++i) {
    const auto low = static_cast<std::uint32_t>(2 + 2 * i);
    const auto next = static_cast<std::uint32_t>(2 + 2 * ((i + 1) % kSides));
    add_triangle(mesh, 0, next, low);
    add_triangle(mesh, 1, low + 1, next + 1);
    add_triangle(mesh, low, next, next + 1);
    add_triangle(mesh, low, next + 1, low + 1);
  }
  return mesh;
}

Mesh sphere_mesh(const Eigen::Vector3d& radii) {
  Mesh mesh;
  constexpr int kRings = kSides / 2;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double polar = std::numbers::pi * ring / kRings;
    for (int i = 0; i < kSides; ++i) {
      const double angle = angle_of(i);
      const Eigen::Vector3d on(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
      mesh.vertices.push_back(on.cwiseProduct(radii).cast<float>());
    }
  }
  for (int ring = 0; ring < kRings; ++ring) {
    for (int i = 0; i < kSides; ++i) {
      const auto a = static_cast<std::uint32_t>(ring * kSides + i);
      const auto b = static_cast<std::uint32_t>(ring * kSides + (i + 1) % kSides);
      if (ring > 0) add_triangle(mesh, a, a + kSides, b);
      if (ring + 1 < kRings) add_triangle(mesh, b, a + kSides, b + kSides);
    }
  }
  return mesh;
}

Mesh plane_mesh(const Eigen::Vector3d& normal, double size_x_m, double size_y_m) {
  Mesh mesh;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
  for (int corner = 0; corner < 4; ++corner)
    mesh.vertices.push_back((turn * Eigen::Vector3d((corner & 1) ? 0.5 * size_x_m : -0.5 * size_x_m,
                                                    (corner & 2) ? 0.5 * size_y_m : -0.5 * size_y_m, 0.0))
                                .cast<float>());
  add_triangle(mesh, 0, 1, 3);
  add_triangle(mesh, 0, 3, 2);
  return mesh;
}

}  // namespace adit::sim
