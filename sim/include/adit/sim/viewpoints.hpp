// Places from which a world is looked at for a data set: drawn along its passages, each by its own number, so that
// frame 7 is the same frame whether ten are made or a thousand.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "adit/fields.hpp"
#include "adit/sim/random.hpp"
#include "adit/sim/scene.hpp"
#include "adit/sim/vehicle.hpp"
#include "adit/sim/world.hpp"

namespace adit::sim {

/// Ranges from which a viewpoint is drawn, evenly.
struct ViewpointConfig {
  double aside_max_fraction = 0.6;
  double above_floor_min_m = 0.6;
  double above_floor_max_m = 1.8;
  double view_yaw_max_deg = 25.0;
  double view_pitch_max_deg = 6.0;
  double view_roll_max_deg = 6.0;
  double view_speed_max_m_s = 1.5;
  double view_turn_max_deg_s = 30.0;
  double free_radius_m = 0.35;
};

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, ViewpointConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"aside_max_fraction", "", 0, 0.95, "Offset from the axis, over half the passage's width.",
                  "chosen: from the axis to near the wall"},
        c.aside_max_fraction);
  visit(FieldNote{"above_floor_min_m", "m", 0.1, 50, "Lowest height.", "paper, 3.2: 1 m"}, c.above_floor_min_m);
  visit(FieldNote{"above_floor_max_m", "m", 0.1, 50, "Largest height.", "paper, 3.2: 1 m"}, c.above_floor_max_m);
  visit(FieldNote{"view_yaw_max_deg", "deg", 0, 180, "Turn from the passage's direction, to either side.",
                  "chosen: the passage stays in a lens of 75 deg"},
        c.view_yaw_max_deg);
  visit(FieldNote{"view_pitch_max_deg", "deg", 0, 60, "Pitch, up and down.", "a quadrotor that brakes: some degrees"},
        c.view_pitch_max_deg);
  visit(FieldNote{"view_roll_max_deg", "deg", 0, 60, "Roll to either side.", "a quadrotor that banks: some degrees"},
        c.view_roll_max_deg);
  visit(FieldNote{"view_speed_max_m_s", "m/s", 0, 20, "Speed forward, for motion blur.", "paper, 3.2: 0.2 m/s"},
        c.view_speed_max_m_s);
  visit(FieldNote{"view_turn_max_deg_s", "deg/s", 0, 720, "Yaw rate to either side, for motion blur.",
                  "limit of the heading controller"},
        c.view_turn_max_deg_s);
  visit(FieldNote{"free_radius_m", "m", 0.05, 5, "Rock is no closer than this.", "a small quadrotor and a margin"},
        c.free_radius_m);
}

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const ViewpointConfig& config);

/// No place in a world is as free as it should be.
struct NoFreePlace : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Draws viewpoints in one world. In worlds whose layout is not known it walks from the start, from free place to free
/// place over the floor, 40 steps at the most.
class ViewpointSource {
 public:
  /// @param world, scene  must outlive the source.
  /// @throws std::invalid_argument naming the field, the value and the range.
  ViewpointSource(const ViewpointConfig& config, const World& world, const RayScene& scene, std::uint64_t seed);

  /// Place, attitude, velocity and yaw rate of one frame.
  /// @throws NoFreePlace when none is found in 200 tries, saying what to change.
  [[nodiscard]] VehicleState draw(std::int64_t frame) const;

 private:
  struct Stand {
    Eigen::Vector3d floor;
    double yaw_rad;
  };
  [[nodiscard]] Stand on_axis(Random& random) const;
  [[nodiscard]] Stand walked(Random& random) const;

  ViewpointConfig config_;
  const World* world_;
  const RayScene* scene_;
  std::uint64_t seed_;
  std::vector<double> passage_ends_m_;  ///< summed lengths: a passage is drawn by its length
};

}  // namespace adit::sim
