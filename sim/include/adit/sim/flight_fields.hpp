// The fields of vehicle, sensors for the map, and flight: name, unit, range, meaning and source, once for all users
// (YAML keys, `--set` keys, docs, checks).
#pragma once

#include <type_traits>

#include "adit/fields.hpp"
#include "adit/sim/vehicle.hpp"

namespace adit::sim {

/// Calls visit(const FieldNote&, member&) for each field, in the order of the struct. `Config` may be const.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, VehicleConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"velocity_lag_s", "s", 0, 5, "First-order lag of the horizontal velocity.",
                  "velocity loops of small quadrotors settle within about a second"},
        c.velocity_lag_s);
  visit(FieldNote{"yaw_rate_lag_s", "s", 0, 5, "First-order lag of the yaw rate.", "about half that of the velocity"},
        c.yaw_rate_lag_s);
  visit(FieldNote{"climb_lag_s", "s", 0, 5, "First-order lag of the climb.", "as the velocity"}, c.climb_lag_s);
  visit(FieldNote{"attitude_lag_s", "s", 0, 2, "First-order lag of roll and pitch.",
                  "attitude loops are some four times as fast as velocity loops"},
        c.attitude_lag_s);
  visit(FieldNote{"tilt_max_deg", "deg", 1, 60, "Limit of roll and of pitch.", "usual limit of autopilots: 30 to 45"},
        c.tilt_max_deg);
  visit(FieldNote{"drag_1_s", "1/s", 0, 3, "Deceleration per speed through the air, of the rotors.",
                  "linear rotor drag, Faessler et al. (2018): some tenths"},
        c.drag_1_s);
  visit(FieldNote{"body_radius_m", "m", 0.02, 2, "Radius of the sphere about all that is hard.",
                  "a small quadrotor, 0.5 m across"},
        c.body_radius_m);
  visit(FieldNote{"height_m", "m", 0.1, 20, "Height over the floor that is kept.", "paper, 3.2: 1 m"}, c.height_m);
  visit(FieldNote{"height_gain_1_s", "1/s", 0, 20, "Climb per metre of missing height.",
                  "a floor of 1:4 at 1 m/s costs 0.17 m"},
        c.height_gain_1_s);
  visit(FieldNote{"climb_max_m_s", "m/s", 0.01, 10, "Limit of the climb.", "any small quadrotor can"}, c.climb_max_m_s);
  visit(FieldNote{"height_filter_s", "s", 0, 5, "First-order filter of the measured height.",
                  "stones on the floor are passed over"},
        c.height_filter_s);
  visit(FieldNote{"height_noise_m", "m", 0, 1, "Standard deviation of a single height reading.",
                  "laser range finders of 40 m: 0.01 to 0.03 m"},
        c.height_noise_m);
  visit(FieldNote{"height_range_max_m", "m", 1, 1000, "Floors further below are not seen: the last height stands.",
                  "laser range finders: 10 to 40 m"},
        c.height_range_max_m);
  visit(FieldNote{"gust_sigma_m_s", "m/s", 0, 10, "Standard deviation of the gusts, along each horizontal axis.",
                  "a tenth to a fifth of the air's speed in ventilated drifts, 0.5 to 4 m/s"},
        c.gust_sigma_m_s);
  visit(FieldNote{"gust_vertical_fraction", "", 0, 2, "Vertical gusts relative to horizontal ones.",
                  "floor and roof are near"},
        c.gust_vertical_fraction);
  visit(FieldNote{"gust_time_s", "s", 0.01, 100, "Correlation time of the gusts (Gauss-Markov, Dryden's first order).",
                  "eddies of a metre or two, carried at 1 to 2 m/s"},
        c.gust_time_s);
  visit(FieldNote{"yaw_rate_noise_rad_s", "rad/s", 0, 2, "Standard deviation of the yaw rate about what is commanded.",
                  "about a degree a second"},
        c.yaw_rate_noise_rad_s);
  visit(FieldNote{"yaw_rate_noise_time_s", "s", 0.01, 100, "Correlation time of that noise.", "about the yaw's lag"},
        c.yaw_rate_noise_time_s);
}

}  // namespace adit::sim
