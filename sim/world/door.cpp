#include "adit/sim/door.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "adit/sim/network.hpp"
#include "sdf_file.hpp"

namespace adit::sim {
namespace {

constexpr double kThickness_m = 0.2;
constexpr double kBeyondWall_m = 1.0;  // rock relief and ribs stand back from the nominal section by less
constexpr double kUnknownWidth_m = 10.0, kUnknownHeight_m = 8.0;

Material steel() {
  Material door;
  door.name = "door";
  door.albedo = 0.3f;  // painted, and dusty
  door.facet_slope = 0.0f;
  door.tint = {1.0f, 1.0f, 1.0f};
  return door;
}

}  // namespace

void close_behind_start(World& world) {
  if (world.materials.size() >= std::numeric_limits<std::uint8_t>::max())
    throw std::invalid_argument("a door is one material more, and there are 255 already");
  const Eigen::Vector3d start = world.start.place.cast<double>();
  double width_m = kUnknownWidth_m, height_m = kUnknownHeight_m, floor_m = start.z() - 0.5 * height_m;
  const Network network(world);
  if (!network.empty()) {
    const AxisPlace section = network.nearest(start);
    width_m = section.width_m + 2.0 * (kBeyondWall_m + section.aside_m);
    height_m = section.height_m + 2.0 * kBeyondWall_m;
    floor_m = section.place.z() - kBeyondWall_m;
  }
  const double yaw_rad = world.start.yaw_rad;
  const Eigen::Vector3d ahead(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
  Eigen::Vector3d middle = start - (kDoorBehind_m + 0.5 * kThickness_m) * ahead;
  middle.z() = floor_m + 0.5 * height_m;
  const Eigen::Affine3d pose = Eigen::Translation3d(middle) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());

  const Mesh box = box_mesh({kThickness_m, width_m, height_m});
  const auto first = static_cast<std::uint32_t>(world.mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : box.vertices)
    world.mesh.vertices.push_back((pose * vertex.cast<double>()).cast<float>());
  for (const auto& triangle : box.triangles) {
    world.mesh.triangles.push_back(triangle + Eigen::Matrix<std::uint32_t, 3, 1>::Constant(first));
    world.mesh.materials.push_back(static_cast<std::uint8_t>(world.materials.size()));
  }
  world.materials.push_back(steel());
}

}  // namespace adit::sim
