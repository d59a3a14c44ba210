// The fields of the configuration structs: name, unit, range, meaning and source, once for all users.
// YAML keys, command-line settings, ROS parameters and the docs are made from these lists.
#pragma once

#include <type_traits>

#include "adit/finder.hpp"
#include "adit/heading.hpp"

namespace adit {

/// What a person needs to know about a field. The default is the struct member's.
struct FieldNote {
  const char* name;     ///< the member's name: also YAML key, ROS parameter and `--set` key
  const char* unit;     ///< "px", "rad/s", ...; "" for unitless
  double minimum;       ///< smallest value allowed; enumerations: 0
  double maximum;       ///< largest value allowed; enumerations: number of names - 1
  const char* meaning;  ///< one sentence
  const char* source;   ///< equation, paper or reason
  bool odd = false;     ///< a size about a middle pixel: odd, or 0 where 0 is allowed
};

/// Calls visit(const FieldNote&, member&) for each field, in the order of the struct. `Config` may be const.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, FinderConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"method", "", 0, 1, "Chain of stages that answers: paper or adit.",
                  "paper: as published; adit: docs/method.md"},
        c.method);
  visit(FieldNote{"patch_size_px", "px", 0, 1023,
                  "Side of the dark channel's patch, odd; 0 takes patch_size_vga_px scaled with the frame's width.",
                  "eq. 3", true},
        c.patch_size_px);
  visit(FieldNote{"patch_size_vga_px", "px", 1, 1023, "Side of the patch for frames 640 px wide, odd.", "eq. 3: 15",
                  true},
        c.patch_size_vga_px);
  visit(FieldNote{"structuring_element_size_px", "px", 0, 1023,
                  "Diameter of the closing's element, odd; 0 takes structuring_element_size_vga_px scaled with the "
                  "frame's width.",
                  "eq. 5", true},
        c.structuring_element_size_px);
  visit(FieldNote{"structuring_element_size_vga_px", "px", 1, 1023,
                  "Diameter of the element for frames 640 px wide, odd.", "not given in the paper; as the patch", true},
        c.structuring_element_size_vga_px);
  visit(FieldNote{"omega", "", 0.01, 1, "Share of the haze that counts in the transmission.",
                  "eq. 3; 0.95 is He et al. (2011)"},
        c.omega);
  visit(FieldNote{"atmospheric_light_fraction", "", 0.000001, 1,
                  "Share of the pixels, brightest in the dark channel, that give the atmospheric light.",
                  "He et al. (2011), 4.4: 0.1 %"},
        c.atmospheric_light_fraction);
  visit(FieldNote{"transmission_min", "", 0.000001, 0.99,
                  "Floor of the transmission, so that the logarithm stays finite.",
                  "eq. 2; below 1 - omega, so that only levels above the atmospheric light meet it"},
        c.transmission_min);
  visit(FieldNote{"scattering_coefficient", "", 0.000001, 1000000,
                  "Beta; it scales the scattering depth and moves no cluster.", "eq. 2; 1: depth in optical depths"},
        c.scattering_coefficient);
  visit(FieldNote{"cluster_count", "", 2, kClusterCountMax, "K of the k-means.", "eq. 6: 10"}, c.cluster_count);
  visit(FieldNote{"clustering", "", 0, 1,
                  "exact: the optimum over the histogram; lloyd: random start and iteration, as published.",
                  "eq. 6 and 7"},
        c.clustering);
  visit(FieldNote{"lloyd_seed", "", 0, 2147483647, "Seed of the random start.", "any"}, c.lloyd_seed);
  visit(FieldNote{"lloyd_starts", "", 1, 1000, "Random starts; the cheapest wins.", "paper: one start"},
        c.lloyd_starts);
  visit(FieldNote{"lloyd_iterations_max", "", 1, 10000, "Iterations of a start at the most.",
                  "not given in the paper; 10 is what the OpenCV samples use"},
        c.lloyd_iterations_max);
  visit(FieldNote{"lloyd_tolerance", "", 0, 1,
                  "A start ends when no centre moves further than this share of the range of depths.",
                  "not given in the paper; far below one grey level of 256"},
        c.lloyd_tolerance);
  visit(FieldNote{"grey16_depth_bits", "bit", 8, 16,
                  "Bits in use in 16-bit grey frames: 10, 12 or 14 for machine-vision sensors.", "the camera's sheet"},
        c.grey16_depth_bits);
  visit(FieldNote{"assumed_hfov_deg", "deg", 10, 170,
                  "Horizontal field of view of the pinhole that stands in where no camera model is given.",
                  "wide setting of the paper's PlayStation Eye: 75"},
        c.assumed_hfov_deg);
  visit(FieldNote{"too_dark_light_max", "level", 0, 255, "too_dark when the atmospheric light is below this.",
                  "about three times the read noise of an 8-bit frame at full gain"},
        c.too_dark_light_max);
  visit(FieldNote{"too_bright_level_min", "level", 1, 256,
                  "too_bright when the darkest level of the closed dark channel is at or above this; 256: never.",
                  "an opening lit by the lamp alone is never in the top fifth of the range"},
        c.too_bright_level_min);
  visit(FieldNote{"contrast_levels_min", "level", 1, 255,
                  "no_contrast when darkest and brightest level of the closed dark channel differ by less.",
                  "a difference that noise of one level cannot make"},
        c.contrast_levels_min);
  visit(FieldNote{"area_fraction_min", "", 0, 1, "no_region when the darkest cluster is a smaller share of the frame.",
                  "what a dead pixel makes with patch and element (0.0006), with a margin of three"},
        c.area_fraction_min);
  visit(FieldNote{"light_gamma", "", 0.2, 5, "Exponent from grey level to light; 1 for a linear camera. Method adit.",
                  "IEC 61966-2-1 (sRGB): 2.2"},
        c.light_gamma);
  visit(FieldNote{"noise_level", "level", 0, 64,
                  "Grey levels that noise adds; darker places count as equally dark. Method adit.",
                  "mean of sixteen pixels, smallest of three noisy colours, at full gain: 1 to 4"},
        c.noise_level);
  visit(FieldNote{"horizon_spread_deg", "deg", 1, 90,
                  "How far from the horizon openings are expected (one standard deviation). Method adit.",
                  "passages rise or fall by some degrees, vehicles pitch by as much; tunnel_practice_2 ramps: 14 deg"},
        c.horizon_spread_deg);
  visit(
      FieldNote{"horizon_floor", "", 0, 1, "Weight of a place far from the horizon; 1: all places alike. Method adit.",
                "a steep way on is still found where nothing else is"},
      c.horizon_floor);
  visit(FieldNote{"way_odds_min", "", -20, 20,
                  "no_opening when the odds of a way on against a wall are less: natural logarithm. Method adit.",
                  "docs/method.md: about one open frame in forty is refused there"},
        c.way_odds_min);
  visit(FieldNote{"dust_veil_min", "", 0, 1,
                  "Share of the light that is veil from which on the air is dusty. Method adit.",
                  "rock in clear air stands a stop or more above the lower envelope of its frame: share below 0.5"},
        c.dust_veil_min);
}

/// See above.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, HeadingConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"gain_per_s", "1/s", 0, 100, "Yaw rate per radian of azimuth.",
                  "1: the error falls to a third in a second, slower than the vehicle's yaw lag of 0.2 s"},
        c.gain_per_s);
  visit(FieldNote{"yaw_rate_max_rad_s", "rad/s", 0, 20, "Limit of the yaw rate.",
                  "keeps motion blur below a patch at 30 frames a second"},
        c.yaw_rate_max_rad_s);
  visit(FieldNote{"yaw_acceleration_max_rad_s2", "rad/s^2", 0.001, 1000, "Limit of the yaw rate's change.",
                  "full rate within half a second"},
        c.yaw_acceleration_max_rad_s2);
  visit(FieldNote{"dead_band_rad", "rad", 0, 1.5, "Azimuths smaller than this are not steered at.",
                  "about the jitter of the centroid from frame to frame"},
        c.dead_band_rad);
  visit(FieldNote{"hold_after_s", "s", 0.001, 60, "Without a fresh bearing for this long, the command is to hold.",
                  "half a metre at 1 m/s"},
        c.hold_after_s);
}

}  // namespace adit
