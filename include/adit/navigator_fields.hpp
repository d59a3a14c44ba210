// The fields of the navigator's configuration structs: name, unit, range, meaning and source, once for all users.
#pragma once

#include "adit/fields.hpp"
#include "adit/navigator.hpp"

namespace adit {

/// Calls visit(const FieldNote&, member&) for each field, in the order of the struct. `Config` may be const.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, ColumnRangeConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"display_gamma", "", 0.3, 4, "Exponent that turns grey levels into light; 1 for linear frames.",
                  "2.2: cameras whose frames are made to be looked at"},
        c.display_gamma);
  visit(FieldNote{"fall_off_exponent", "", 0, 40, "Light falls with this power of the angle's cosine to the axis.",
                  "4: vignetting of a simple lens; the rest: a flood lamp"},
        c.fall_off_exponent);
  visit(FieldNote{"band_low_deg", "deg", -60, 0, "Lower edge of the band about the horizon that is looked at.",
                  "floor from 14 m on for a camera 1 m up"},
        c.band_low_deg);
  visit(FieldNote{"band_high_deg", "deg", 1, 60, "Upper edge of that band.",
                  "below a roof of 3 m until the wall is 11 m away"},
        c.band_high_deg);
  visit(
      FieldNote{"camera_height_m", "m", 0.05, 50, "Camera over the floor: the scale of the ranges.", "paper, 3.2: 1 m"},
      c.camera_height_m);
  visit(FieldNote{"range_min_m", "m", 0.01, 10, "Shortest range.", "a body's radius"}, c.range_min_m);
  visit(FieldNote{"range_max_m", "m", 1, 100, "Longest range: darker rock is not told from no rock.",
                  "1/144 of the light at 1 m: a few grey levels"},
        c.range_max_m);
  visit(FieldNote{"veil_per_extinction_m", "m", 0.01, 100,
                  "Light that dust throws back, as a share of what square rock at 1 m does, per extinction in 1/m.",
                  "simulated: lamps 0.18 m beside the camera, Henyey-Greenstein g 0.7; nearer lamps: more"},
        c.veil_per_extinction_m);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, RangeMemoryConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"range_smoothing_s", "s", 0, 5, "Time constant of the ranges.", "a third of hold_after_s"},
        c.range_smoothing_s);
  visit(FieldNote{"veil_rise_s", "s", 0.1, 3600, "Time constant of a thickening veil.",
                  "slower than the way up to a dead end, which also brightens the darkest column"},
        c.veil_rise_s);
  visit(FieldNote{"keep_s", "s", 0, 60, "Walls that left the frame are remembered for this long.",
                  "the way past what was at the frame's edge, at 1 m/s"},
        c.keep_s);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, TrackerConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"gate_rad", "rad", 0.01, 3, "An opening this near to a track continues it.",
                  "a sixth of a lens of 75 deg; 0.8 rad/s for a quarter of a second"},
        c.gate_rad);
  visit(FieldNote{"bearing_smoothing_s", "s", 0, 5, "Time constant of a track's bearing.", "that of the vehicle's yaw"},
        c.bearing_smoothing_s);
  visit(FieldNote{"trust_s", "s", 0, 5, "Time constant with which a track's score grows while it is seen.",
                  "some frames, at 20 Hz and more"},
        c.trust_s);
  visit(FieldNote{"forget_s", "s", 0.01, 60, "Time constant with which it falls while it is not seen.",
                  "longer than hold_after_s"},
        c.forget_s);
  visit(FieldNote{"switch_ratio", "", 1, 10, "Another opening has to be better by this.",
                  "above the scatter of scores from frame to frame"},
        c.switch_ratio);
  visit(FieldNote{"switch_after_s", "s", 0, 60, "... for this long before it is chosen instead.", "as hold_after_s"},
        c.switch_after_s);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, SteeringConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"prefer", "", 0, 3, "Which way where the passage branches.", "straight: the fewest turns"}, c.prefer);
  visit(FieldNote{"body_half_width_m", "m", 0.01, 5, "Of the sphere about all that is hard.",
                  "a small quadrotor, 0.5 m across"},
        c.body_half_width_m);
  visit(FieldNote{"margin_m", "m", 0, 5, "Kept free beside the body, or a way counts as closed.",
                  "a gust's push and the ranges' error at a few metres"},
        c.margin_m);
  visit(FieldNote{"clearance_m", "m", 0.1, 20, "Walls nearer to the way than this are kept away from.",
                  "half a drift of 5 m"},
        c.clearance_m);
  visit(FieldNote{"look_ahead_m", "m", 0.5, 50, "Part of a way that walls are kept away from.",
                  "critically damped at 1 m/s with gain_per_s 1: 4 v / gain"},
        c.look_ahead_m);
  visit(FieldNote{"clearance_weight", "", 0, 1000, "Cost of a wall on the way.", "walls count before directions"},
        c.clearance_weight);
  visit(FieldNote{"goal_weight", "1/rad^2", 0, 1000, "Cost of a way beside the middle of the gap.", "1: the unit"},
        c.goal_weight);
  visit(FieldNote{"change_weight", "1/rad^2", 0, 1000, "Cost of a way beside the last one.", "half of goal_weight"},
        c.change_weight);
  visit(FieldNote{"stop_range_m", "m", 0.1, 50, "A way that ends nearer than this is closed.",
                  "way to stop from 1 m/s, and room to turn"},
        c.stop_range_m);
  visit(FieldNote{"slow_range_m", "m", 0.1, 50, "The vehicle slows down when the way ahead is shorter than this.",
                  "twice stop_range_m"},
        c.slow_range_m);
  visit(FieldNote{"turn_rate_rad_s", "rad/s", 0.01, 10, "Yaw rate of a turn in place.",
                  "motion blur of a pixel or two at 640 px and 1/100 s"},
        c.turn_rate_rad_s);
  visit(FieldNote{"turn_min_rad", "rad", 0, 6, "A turn in place is at least this long.", "more than half a lens"},
        c.turn_min_rad);
  visit(FieldNote{"clear_range_m", "m", 0.1, 50, "Free way that ends a turn in place.",
                  "well above stop_range_m, so that it does not turn again at once"},
        c.clear_range_m);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, FrameWatchConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"frozen_frames", "frame", 2, 1000, "So many frames in a row, the same to the last bit: frozen_frame.",
                  "two are a driver's hiccup; three are named"},
        c.frozen_frames);
  visit(FieldNote{"torn_fraction_min", "", 0.02, 1, "Share of the rows that have to be of another frame: torn_frame.",
                  "less does no harm"},
        c.torn_fraction_min);
  visit(FieldNote{"torn_frames_max", "frame", 1, 1000000,
                  "What looks torn for longer is how this camera's frames look: a mask, a part of the vehicle.",
                  "a second at 30 Hz"},
        c.torn_frames_max);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, LensWatchConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"turn_step_rad", "rad", 0.01, 1, "The lens is looked at whenever the vehicle has turned by this.",
                  "two cells of 75 deg / 80"},
        c.turn_step_rad);
  visit(FieldNote{"each_way_min_rad", "rad", 0.05, 6, "Turned to the left, and to the right, before dirt is named.",
                  "three times the rim and its width: a way on has moved through it"},
        c.each_way_min_rad);
  visit(FieldNote{"looks_min", "", 3, 1000, "Looks before dirt is named.", "a smooth curve's rim shows itself by then"},
        c.looks_min);
  visit(FieldNote{"dark_fraction", "", 0.05, 0.9,
                  "Dark is what lies lower than this between the frame's darkest place and its median.",
                  "flights: black dirt 0 to 0.2, rock from 0.5 on"},
        c.dark_fraction);
  visit(FieldNote{"rim_rad", "rad", 0.01, 0.5, "So far from the dirt it is not dark.",
                  "width of a spot's soft edge: aperture over its distance to the glass"},
        c.rim_rad);
}

}  // namespace adit
