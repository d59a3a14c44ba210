// What only the simulator knows, frame by frame, from geometry: where the passage goes, where it is deepest, how near
// the rock is.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/sim/network.hpp"
#include "adit/sim/scene.hpp"

namespace adit::sim {

/// How truth is taken; unit, range and source of each field stand in visit_fields() (flight_fields.hpp).
struct TruthConfig {
  double look_ahead_m = 5.0;
  double sight_max_m = 60.0;
  double sight_smoothing_deg = 4.0;
  double opening_range_min_m = 4.0;
  double branch_range_m = 20.0;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const TruthConfig& config);

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Truth of one moment. Azimuths and elevations are those of the camera, as the finder's: positive to the right, up.
struct Truth {
  Bearing passage{kUnknown, kUnknown};  ///< of the passage look_ahead_m further on; where it branches, of the branch
                                        ///< closest to the camera's axis; NaN where none goes on
  Bearing deepest{kUnknown, kUnknown};  ///< of the longest smoothed range in the camera's frame
  double deepest_range_m = kUnknown;    ///< that range, at most sight_max_m
  std::vector<Bearing> branches;        ///< all that go on and can be seen, in the frame or not; the way
                                        ///< that leads to a junction in sight is none of them
  bool opening_in_sight = false;        ///< deepest_range_m >= opening_range_min_m
  double clearance_m = kUnknown;        ///< from the body's centre to the nearest rock, all directions
  double side_clearance_m = kUnknown;   ///< the same over horizontal rays alone
  double aside_m = kUnknown;            ///< from the passage's axis, horizontally; NaN without a layout
  double progress_m = kUnknown;         ///< along the route since the start; NaN without a layout
  double to_goal_m = kUnknown;          ///< along the route; infinity or NaN where there is none
};

/// The camera's place and its rotation from the optical frame (x right, y down, z forward) to the world.
using CameraPose = Eigen::Isometry3d;

/// Direction from the camera to a point.
[[nodiscard]] Bearing bearing_to(const CameraPose& camera_pose, const Eigen::Vector3d& point);

/// Range along the ray of every pixel, rows one after the other, m; range_max_m where nothing is met.
[[nodiscard]] std::vector<float> range_image_m(const RayScene& scene, const Camera& camera,
                                               const CameraPose& camera_pose, float range_max_m);

/// Takes truth from a scene and, where the layout is known, from its network.
class Surveyor {
 public:
  /// @param scene, network  must outlive the surveyor. @param hfov_deg of the camera, 10 to 170.
  Surveyor(const TruthConfig& config, const RayScene& scene, const Network& network, double hfov_deg);

  [[nodiscard]] const TruthConfig& config() const noexcept { return config_; }

  /// @param body  centre of the body. @param heading  unit, where its nose points, horizontal.
  /// @param height_m  over the floor at which the passage's axis is looked at.
  /// @param start  where the flight began, for progress; empty without a layout.
  [[nodiscard]] Truth look(const Eigen::Vector3d& body, const Eigen::Vector3d& heading, const CameraPose& camera_pose,
                           double height_m, const std::optional<AxisPlace>& start) const;

  /// Distances alone, m: clearance over all directions, and over horizontal rays.
  void measure_clearance(const Eigen::Vector3d& body, Truth& truth) const;

 private:
  void follow_network(const Eigen::Vector3d& body, const Eigen::Vector3d& heading, const CameraPose& camera_pose,
                      double height_m, const std::optional<AxisPlace>& start, Truth& truth) const;
  void find_gap(const Eigen::Vector3d& body, const Eigen::Vector3d& heading, const CameraPose& camera_pose,
                Truth& truth) const;
  void find_deepest(const CameraPose& camera_pose, Truth& truth) const;

  TruthConfig config_;
  const RayScene* scene_;
  const Network* network_;
  double hfov_deg_;
  std::vector<float> circle_rad_;  ///< angles of the horizontal rays
};

}  // namespace adit::sim
