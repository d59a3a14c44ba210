// One SDF file, with its includes cut out and named: what stands in it, and where.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "adit/sim/world.hpp"
#include "adit/sim/world_file.hpp"

namespace adit::sim {

/// A shape with its pose in the file's frame: a mesh of a file, or triangles made here.
struct SdfShape {
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();  ///< with the mesh's scale
  std::string mesh_uri;                                ///< empty: `made` holds the triangles
  std::string submesh;
  bool centre_submesh = false;
  Mesh made;
  bool has_colour = false;  ///< of the visual's material
  float albedo = 0.2f;
  Eigen::Vector3f tint = {1.0f, 1.0f, 1.0f};
};

/// Another file at a pose.
struct SdfInclusion {
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  bool has_pose = true;  ///< false: the included model's own pose counts
  std::string name;
  std::string uri;
};

struct SdfFile {
  std::string name;
  bool is_model = false;
  Eigen::Affine3d model_pose = Eigen::Affine3d::Identity();  ///< a model's own pose, not yet applied
  std::vector<SdfShape> shapes;
  std::vector<SdfInclusion> inclusions;
  std::vector<WorldLamp> lamps;
  std::vector<std::string> notes;
};

/// Reads one file. @throws WorldError "FILE:LINE: ..." for broken XML or what is no SDF.
[[nodiscard]] SdfFile read_sdf_file(const std::string& path, Geometry geometry);

/// Triangles of Gazebo's simple shapes, about the origin. Seen from outside.
[[nodiscard]] Mesh box_mesh(const Eigen::Vector3d& size);
[[nodiscard]] Mesh cylinder_mesh(double radius_m, double length_m);
[[nodiscard]] Mesh sphere_mesh(const Eigen::Vector3d& radii);
/// @param size  endless planes come as what they are given here
[[nodiscard]] Mesh plane_mesh(const Eigen::Vector3d& normal, double size_x_m, double size_y_m);

}  // namespace adit::sim
