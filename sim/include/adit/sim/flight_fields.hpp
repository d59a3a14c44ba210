// The fields of vehicle, sensors for the map, and flight: name, unit, range, meaning and source, once for all users
// (YAML keys, `--set` keys, docs, checks).
#pragma once

#include <type_traits>

#include "adit/fields.hpp"
#include "adit/navigator_fields.hpp"
#include "adit/sim/flight.hpp"
#include "adit/sim/lidar.hpp"
#include "adit/sim/truth.hpp"
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

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, TruthConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"look_ahead_m", "m", 0.5, 50, "How far ahead the passage's direction is taken.",
                  "a few seconds of flight at 1 m/s"},
        c.look_ahead_m);
  visit(FieldNote{"sight_max_m", "m", 5, 1000, "Ranges beyond count as this one.", "no lamp on a robot lights further"},
        c.sight_max_m);
  visit(FieldNote{"sight_smoothing_deg", "deg", 0, 30, "Width over which ranges are averaged.",
                  "about a vehicle's width at 7 m"},
        c.sight_smoothing_deg);
  visit(FieldNote{"opening_range_min_m", "m", 0.5, 50, "Deepest range from which on there is an opening in sight.",
                  "a little more than half a wide drift, less than the way to turn in"},
        c.opening_range_min_m);
  visit(FieldNote{"branch_range_m", "m", 1, 200, "Junctions up to here count as in sight.", "reach of the lamp"},
        c.branch_range_m);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, LidarConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"lidar_rate_hz", "Hz", 0.1, 100, "Sweeps a second.", "scanners turn at 10 to 40 Hz"},
        c.lidar_rate_hz);
  visit(FieldNote{"lidar_fov_deg", "deg", 10, 359, "Angle of a sweep.", "Hokuyo UTM-30LX: 270"}, c.lidar_fov_deg);
  visit(FieldNote{"lidar_rays", "", 8, 8192, "Rays of a sweep.", "Hokuyo UTM-30LX: 1081; every second one"},
        c.lidar_rays);
  visit(FieldNote{"lidar_range_min_m", "m", 0, 5, "Shortest range.", "Hokuyo UTM-30LX: 0.1"}, c.lidar_range_min_m);
  visit(FieldNote{"lidar_range_max_m", "m", 1, 300, "Longest range.", "Hokuyo UTM-30LX: 30"}, c.lidar_range_max_m);
  visit(FieldNote{"lidar_noise_m", "m", 0, 1, "Standard deviation of a range.",
                  "Hokuyo UTM-30LX: 0.01 to 10 m, 0.03 beyond"},
        c.lidar_noise_m);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, ImuConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"gyro_noise_rad_s_rthz", "rad/s/sqrt(Hz)", 0, 0.1, "Noise density of the gyroscopes.",
                  "InvenSense MPU-6050: 0.005 deg/s/sqrt(Hz)"},
        c.gyro_noise_rad_s_rthz);
  visit(FieldNote{"gyro_bias_rad_s", "rad/s", 0, 1, "Standard deviation of their biases from flight to flight.",
                  "what is left after a calibration at rest"},
        c.gyro_bias_rad_s);
  visit(FieldNote{"accelerometer_noise_m_s2_rthz", "m/s^2/sqrt(Hz)", 0, 1, "Noise density of the accelerometers.",
                  "InvenSense MPU-6050: 400 ug/sqrt(Hz)"},
        c.accelerometer_noise_m_s2_rthz);
  visit(FieldNote{"accelerometer_bias_m_s2", "m/s^2", 0, 5, "Standard deviation of their biases from flight to flight.",
                  "what is left after a calibration at rest"},
        c.accelerometer_bias_m_s2);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, FlightConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"pilot", "", 0, 2,
                  "by_method: the published controller for method paper, the navigator for every other; published, "
                  "navigator: that one.",
                  "docs/navigation.md"},
        c.pilot);
  visit(FieldNote{"speed_m_s", "m/s", 0.05, 10, "Forward speed while it steers or coasts.", "paper, 3.2: 0.2 m/s"},
        c.speed_m_s);
  visit(FieldNote{"time_max_s", "s", 0.1, 36000, "The flight ends after this time.", "paper, Fig. 3: 180 s"},
        c.time_max_s);
  visit(FieldNote{"physics_rate_hz", "Hz", 20, 5000,
                  "Steps of the vehicle a second, at the least; a whole number of them fills a frame's interval.",
                  "twenty steps in the shortest lag"},
        c.physics_rate_hz);
  visit(FieldNote{"camera_rate_hz", "Hz", 1, 240, "Frames a second.", "paper, 3.2: 30"}, c.camera_rate_hz);
  visit(FieldNote{"camera_delay_frames", "frame", 0, 30, "Frames from the exposure to the command made of it.",
                  "read-out, transfer and judging take about one"},
        c.camera_delay_frames);
  visit(FieldNote{"drop_fraction", "", 0, 1, "Share of the frames that never arrive.", "USB cameras under load"},
        c.drop_fraction);
  visit(FieldNote{"repeat_fraction", "", 0, 1, "Share of the frames that bring the pixels of the one before.",
                  "USB cameras under load"},
        c.repeat_fraction);
  visit(FieldNote{"stop_after_s", "s", 0.1, 600, "Told to hold for so long, the flight ends as stopped.",
                  "nothing changes any more for a hovering camera"},
        c.stop_after_s);
  visit(FieldNote{"stuck_radius_m", "m", 0.1, 50, "Flown stuck_after_m within a circle of this, it is stuck.",
                  "circles of full yaw rate at 1 m/s"},
        c.stuck_radius_m);
  visit(FieldNote{"stuck_after_m", "m", 1, 1000, "See stuck_radius_m.", "twice around such a circle"}, c.stuck_after_m);
  visit(FieldNote{"map_cell_m", "m", 0.02, 2, "Cell of the occupancy grid.", "three times the noise of the ranges"},
        c.map_cell_m);
  visit(FieldNote{"start_jitter_m", "m", 0, 10, "Starts are drawn to the side of the start by up to this.",
                  "so that seeds are different flights"},
        c.start_jitter_m);
  visit(FieldNote{"start_yaw_jitter_deg", "deg", 0, 180, "Starts are drawn to be turned by up to this.",
                  "so that seeds are different flights"},
        c.start_yaw_jitter_deg);
}

}  // namespace adit::sim
