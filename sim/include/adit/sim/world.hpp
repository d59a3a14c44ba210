// What there is to see and to hit: rock as triangles, what it is made of, lamps that hang in it, and how its
// passages run. Units: metres; frame: x forward, y left, z up (REP 103).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace adit::sim {

/// How a surface answers light.
struct Material {
  std::string name;
  float albedo = 0.2f;            ///< mean diffuse reflectance, 0.02 (coal) to 0.6 (limestone, gypsum)
  float albedo_log_sigma = 0.0f;  ///< sigma of the log-normal patches about it, 0 to 1
  float patch_size_m = 0.5f;      ///< size of these patches, 0.05 to 5 m
  float specular = 0.0f;          ///< weight of the specular lobe, 0 to 0.5 (wet)
  float shininess = 30.0f;        ///< its exponent, 1 to 500
  float emission_cd_m2 = 0.0f;    ///< luminance of the surface itself (a lamp's glass), 0 to 1e6
  float facet_slope = 0.35f;      ///< rms slope of facets finer than the mesh, 0 (smooth pipe) to 1 (blasted rock)
  float facet_size_m = 0.30f;     ///< size of the largest of them, 0.02 to 2 m
  Eigen::Vector3f tint = {1.0f, 0.93f, 0.80f};  ///< red, green, blue reflectance relative to albedo, 0 to 1.5
};

/// Triangles with a material each.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Matrix<std::uint32_t, 3, 1>> triangles;  ///< counter-clockwise seen from the open side
  std::vector<std::uint8_t> materials;                        ///< one a triangle, an index into World::materials
};

/// A lamp that stands in the world and not on the vehicle.
struct WorldLamp {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  Eigen::Vector3f axis = -Eigen::Vector3f::UnitZ();
  float lobe_exponent = 0.0f;     ///< intensity ~ cos^n of the angle to the axis; 0 shines alike into all directions
  float flux_lm = 1000.0f;        ///< lumen, 10 to 20000
  float emitter_radius_m = 0.1f;  ///< of the sphere that is seen, 0.01 to 0.5 m
};

/// A point of a passage's axis. The axis lies on the nominal floor, in the middle of the passage.
struct AxisPoint {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  float width_m = 0.0f;
  float height_m = 0.0f;
};

/// A stretch of passage between two nodes of the network. Its first and last point are the nodes' places.
struct Passage {
  int from = -1;                ///< node
  int to = -1;                  ///< node
  std::vector<AxisPoint> axis;  ///< about every 0.5 m
};

/// What a node of the network is.
enum class NodeKind : std::uint8_t { kMouth, kBend, kJunction, kDeadEnd, kGoal };

struct Node {
  NodeKind kind = NodeKind::kBend;
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
};

/// Where a flight begins: feet on the axis, nose along it.
struct StartPose {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  float yaw_rad = 0.0f;  ///< counter-clockwise from +x
};

struct World {
  std::string name;
  std::vector<Material> materials;
  Mesh mesh;
  std::vector<WorldLamp> lamps;
  float sky_lux = 0.0f;  ///< illuminance of daylight where rays leave the mesh, 0 (night) to 100000
  StartPose start;
  std::vector<Node> nodes;  ///< empty where the layout is not known (a bare mesh)
  std::vector<Passage> passages;
  std::vector<std::string> notes;  ///< what was passed over while loading: models not found, lights dropped, ...
};

}  // namespace adit::sim
