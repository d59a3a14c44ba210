// Courses of our own: a plan of passages, from which rock is grown with a seed. See courses/*.yaml.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adit/sim/world.hpp"

namespace adit::sim {

/// How the passages of a course come about.
enum class LayoutKind : std::uint8_t {
  kMoves,          ///< CourseConfig::passages, move by move
  kRandomTunnel,   ///< one winding passage of length_m, from the seed
  kRandomNetwork,  ///< passages with branches on a grid, length_m in all, from the seed
  kTiles,          ///< CourseConfig::tiles: the layout of a tiled Gazebo world
};

/// One stretch of a passage: straight on, or along an arc.
struct Move {
  double straight_m = 0.0;  ///< length of a straight stretch, 0 to 1000 m; 0 where turn_deg is given
  double turn_deg = 0.0;    ///< angle of an arc, positive to the left, -360 to 360 deg
  double radius_m = 0.0;    ///< its radius on the axis, 1 to 1000 m
  double rise_m = 0.0;      ///< of the floor over the whole stretch, negative downwards
  double width_m = 0.0;     ///< at the end of the stretch, reached evenly; 0 keeps what it was
  double height_m = 0.0;    ///< the same for the height
};

/// A passage from a named node to another one.
struct PassagePlan {
  std::string from = "start";         ///< a node that an earlier passage made; "start" lies at the origin, towards +x
  std::string to;                     ///< a new node
  NodeKind end = NodeKind::kBend;     ///< what the new node is; kGoal is followed by run_out_m of passage and a mouth
  std::optional<double> heading_deg;  ///< counter-clockwise from +x; without it the passage goes straight on
  double width_m = 0.0;               ///< at its beginning; 0 keeps that of the node
  double height_m = 0.0;              ///< the same for the height
  std::vector<Move> moves;
};

/// A round room about a point.
struct RoomPlan {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double width_m = 10.0;  ///< diameter, 2 to 60 m
  double height_m = 6.0;  ///< 2 to 30 m
};

/// A tile of a Gazebo world, by the name of its model, and where it lies.
struct TilePlan {
  std::string model;
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double yaw_rad = 0.0;
};

/// A lamp that hangs in the course.
struct LampPlan {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double flux_lm = 1000.0;
  double emitter_radius_m = 0.1;
};

/// Shape of the cross-section is one number: the radius of the crown's corners as a share of what fits.
inline constexpr double kCrownOfArch = 1.0;
inline constexpr double kCrownOfDrift = 0.45;

/// Every parameter of a course. Unit, range, meaning and source of each stand in visit_fields() (course_fields.hpp).
struct CourseConfig {
  std::string name = "course";
  std::string about;  ///< one line for people
  LayoutKind layout = LayoutKind::kMoves;
  int seed = 1;

  double width_m = 5.0;
  double height_m = 3.5;
  double crown_fraction = kCrownOfDrift;
  double blend_m = 0.6;
  double run_out_m = 15.0;
  double start_along_m = 3.0;
  double start_offset_m = 0.0;
  double start_yaw_deg = 0.0;
  double apron_m = 0.0;
  double sky_lux = 0.0;

  double length_m = 150.0;
  double width_min_m = 4.0;
  double width_max_m = 6.0;
  double radius_min_m = 7.0;
  double turn_max_deg = 100.0;
  double grade_max = 0.08;
  double branch_probability = 0.35;
  double grid_m = 25.0;
  double goal_min_m = 100.0;

  double cell_m = 0.13;
  double undulation_m = 0.16;
  double undulation_size_m = 4.0;
  double facet_depth_m = 0.17;
  double facet_size_m = 1.3;
  double chip_depth_m = 0.06;
  double chip_size_m = 0.45;
  double grain_depth_m = 0.025;
  double grain_size_m = 0.3;
  double floor_roughness_m = 0.035;

  double rock_albedo = 0.22;
  double rock_albedo_log_sigma = 0.35;
  double wet_fraction = 0.12;
  double stones_per_m2 = 2.0;
  double stone_size_m = 0.09;
  double pipe_count = 2;
  double cable_count = 2;
  double prop_spacing_m = 9.0;
  double duct_diameter_m = 0.0;

  std::vector<PassagePlan> passages;
  std::vector<RoomPlan> rooms;
  std::vector<TilePlan> tiles;
  std::vector<LampPlan> lamps;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const CourseConfig& config);

/// Reads courses/NAME.yaml. @throws WorldError: "FILE:LINE: ...", with the known keys where a key is unknown.
[[nodiscard]] CourseConfig read_course(const std::string& path);

/// Grows the rock. The same configuration gives the same bytes on any number of threads.
/// @throws WorldError when fault_of() has something to say or the layout cannot be built.
[[nodiscard]] World build_course(const CourseConfig& config);

}  // namespace adit::sim
