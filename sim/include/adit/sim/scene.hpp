// Rays against the world's mesh: what is seen, what is in the way, what is touched (Embree 3 or 4).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// Where a ray meets the rock.
struct Hit {
  float range_m = 0.0f;    ///< from the ray's origin, along its unit direction
  Eigen::Vector3f place;   ///< world frame
  Eigen::Vector3f normal;  ///< unit, of the triangle, turned towards the origin of the ray
  std::uint32_t triangle = 0;
};

/// The place of the mesh that is closest to a point.
struct Nearest {
  float distance_m = 0.0f;
  Eigen::Vector3f place;  ///< on the mesh
  std::uint32_t triangle = 0;
};

/// Where a moving sphere first touches the mesh.
struct Contact {
  float fraction = 0.0f;   ///< of the way from start to end, [0, 1]; 0 when it touches already at the start
  Eigen::Vector3f centre;  ///< of the sphere at that moment
  Eigen::Vector3f place;   ///< on the mesh
};

inline constexpr int kPacket = 16;

/// Sixteen rays in structure-of-arrays order, for loops that shade many points at once; neighbours should go about the
/// same way. Lanes with tfar < tnear are idle.
struct alignas(64) RayPacket {
  float origin[3][kPacket];
  float direction[3][kPacket];  ///< of any length but 0; tnear and tfar are multiples of it
  float tnear[kPacket];
  float tfar[kPacket];
};

/// What a RayPacket met. Lanes without a hit keep triangle == kNoTriangle and tfar.
struct alignas(64) HitPacket {
  float t[kPacket];
  float normal[3][kPacket];      ///< not normalised, not turned
  float u[kPacket], v[kPacket];  ///< barycentric
  std::uint32_t triangle[kPacket];
};

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// The mesh in a tree of boxes. Immutable once built, so that any number of threads may ask at once.
/// Triangles have two sides: normals are turned towards whoever looks.
class RayScene {
 public:
  /// @throws std::invalid_argument when the mesh has no triangle, an index past its vertices, a vertex that is not
  ///         finite, or a list of materials that does not fit; std::runtime_error when Embree cannot build it.
  explicit RayScene(const Mesh& mesh);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Closest hit within range_max_m. @param direction unit length.
  [[nodiscard]] std::optional<Hit> closest_hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                               float range_max_m = 1e9f) const;
  /// Whether rock lies between two points; the last millimetre at either end does not count.
  [[nodiscard]] bool occluded(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

  /// Ranges of a fan of rays in the world's horizontal plane; lane i looks along yaw_rad + angles_rad[i]
  /// (counter-clockwise from +x). Ranges past range_max_m come back as range_max_m.
  [[nodiscard]] std::vector<float> horizontal_ranges_m(const Eigen::Vector3f& origin, float yaw_rad,
                                                       std::span<const float> angles_rad, float range_max_m) const;

  /// The closest place of the mesh, or empty when there is none within radius_m.
  [[nodiscard]] std::optional<Nearest> nearest(const Eigen::Vector3f& point, float radius_m) const;

  /// First touch of a sphere whose centre goes straight from start to end; empty when it never touches. Conservative
  /// advancement: the sphere is moved by its free distance until that falls under kContactTolerance_m, so it never
  /// passes a wall whatever the step.
  [[nodiscard]] std::optional<Contact> first_contact(const Eigen::Vector3f& start, const Eigen::Vector3f& end,
                                                     float radius_m) const;
  static constexpr float kContactTolerance_m = 1e-4f;

  void intersect(const RayPacket& rays, HitPacket& hits) const;
  /// Bit i is set when lane i meets anything between tnear and tfar.
  [[nodiscard]] std::uint32_t occluded(const RayPacket& rays) const;

  [[nodiscard]] std::size_t triangle_count() const noexcept;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace adit::sim
