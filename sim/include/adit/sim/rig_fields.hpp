// The fields of the simulator's rig: name, unit, plausible range, meaning and source, once for all users.
// YAML keys, command-line settings and the docs are made from these lists. See adit/fields.hpp.
#pragma once

#include <type_traits>

#include "adit/fields.hpp"
#include "adit/sim/render.hpp"

namespace adit::sim {

/// Calls visit(const FieldNote&, member&) for each field, in the order of the struct. `Config` may be const.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, Lamp>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"forward_m", "m", -1, 1, "Place in the body frame.", "the vehicle's drawing"}, c.forward_m);
  visit(FieldNote{"left_m", "m", -1, 1, "Place in the body frame.", "0.08 to 0.25 m beside the camera on flown robots"},
        c.left_m);
  visit(FieldNote{"up_m", "m", -1, 1, "Place in the body frame.", "the vehicle's drawing"}, c.up_m);
  visit(FieldNote{"yaw_deg", "deg", -180, 180, "Turn of the axis to the left.", "the vehicle's drawing"}, c.yaw_deg);
  visit(FieldNote{"pitch_deg", "deg", -90, 90, "Turn of the axis upwards.", "the vehicle's drawing"}, c.pitch_deg);
  visit(FieldNote{"lux_at_1m", "lx", 0, 20000, "Illuminance on the axis at 1 m; 0: flux_lm counts.",
                  "paper, 3.2: 460 and 40 lux for the whole vehicle"},
        c.lux_at_1m);
  visit(
      FieldNote{"flux_lm", "lm", 0, 20000, "Light in all directions together.", "data sheets of head torches and bars"},
      c.flux_lm);
  visit(FieldNote{"lobe_exponent", "", 0, 200, "n of cos^n: 1 a bare LED, 2 to 4 a flood, 10 to 40 a spot.",
                  "half-angle of half intensity: acos(0.5^(1/n))"},
        c.lobe_exponent);
  visit(FieldNote{"edge_deg", "deg", 1, 90, "Half-angle where the optics cut the beam; 90: nowhere.", "optics' sheet"},
        c.edge_deg);
  visit(FieldNote{"edge_softness_deg", "deg", 0.1, 45, "Half the width of that edge.", "frames of robots with spots"},
        c.edge_softness_deg);
  visit(FieldNote{"spill_fraction", "", 0, 1, "Share of the axis's intensity that goes everywhere, as cos.",
                  "stray light of reflectors, some per cent"},
        c.spill_fraction);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, LampRig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"tint_red", "", 0.1, 3, "Red of all lamps, relative to green.", "white LEDs 4000 to 6500 K"},
        c.tint_red);
  visit(FieldNote{"tint_blue", "", 0.1, 3, "Blue of all lamps, relative to green.", "white LEDs 4000 to 6500 K"},
        c.tint_blue);
  visit(FieldNote{"flash", "", 0, 1, "The vehicle's lamps are on in even frames and off in odd ones.",
                  "for what takes frames in pairs: adit run --flash"},
        c.flash);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, DustConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"extinction_1_m", "1/m", 0, 0.5, "Light lost per metre, by scattering and absorption.",
                  "meteorological range 3.9 / extinction: 0.1 is 39 m, 0.5 is 8 m"},
        c.extinction_1_m);
  visit(FieldNote{"scattering_albedo", "", 0, 1, "Share of the extinction that is scattering.",
                  "0.3 soot and coal, 0.9 mineral dust"},
        c.scattering_albedo);
  visit(FieldNote{"asymmetry", "", -0.9, 0.95, "Henyey-Greenstein g: mean cosine of the turn.",
                  "0.6 to 0.85 for grains larger than the wavelength"},
        c.asymmetry);
  visit(FieldNote{"grains_per_m3", "1/m^3", 0, 5000, "Grains big enough to be seen one by one near the lens.",
                  "frames behind rotors: some tens in sight"},
        c.grains_per_m3);
  visit(FieldNote{"grain_diameter_mm", "mm", 0.02, 2, "Their diameter.", "coarse dust stirred up by rotors"},
        c.grain_diameter_mm);
  visit(FieldNote{"grain_drift_m_s", "m/s", 0, 10, "Speed of the air that carries them.",
                  "mine ventilation 0.1 to 4 m/s"},
        c.grain_drift_m_s);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, LensConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"width", "px", 16, 4096, "Frame.", "paper: 640"}, c.width);
  visit(FieldNote{"height", "px", 16, 4096, "Frame.", "paper: 480"}, c.height);
  visit(FieldNote{"hfov_deg", "deg", 20, 130, "Horizontal field of view, before distortion; 60 to 110 is usual.",
                  "PlayStation Eye: 56 or 75"},
        c.hfov_deg);
  visit(FieldNote{"k1", "", -1, 1, "Radial distortion.", "plumb_bob, as in camera.hpp"}, c.k1);
  visit(FieldNote{"k2", "", -1, 1, "Radial distortion.", "plumb_bob"}, c.k2);
  visit(FieldNote{"p1", "", -0.1, 0.1, "Tangential distortion.", "plumb_bob"}, c.p1);
  visit(FieldNote{"p2", "", -0.1, 0.1, "Tangential distortion.", "plumb_bob"}, c.p2);
  visit(FieldNote{"k3", "", -1, 1, "Radial distortion.", "plumb_bob"}, c.k3);
  visit(FieldNote{"forward_m", "m", -1, 1, "Place in the body frame.", "SubT X3: 0.10"}, c.forward_m);
  visit(FieldNote{"left_m", "m", -1, 1, "Place in the body frame.", "SubT X3: 0"}, c.left_m);
  visit(FieldNote{"up_m", "m", -1, 1, "Place in the body frame.", "SubT X3: 0"}, c.up_m);
  visit(FieldNote{"pitch_deg", "deg", -60, 60, "Turn of the axis upwards.", "SubT X3: 0"}, c.pitch_deg);
  visit(FieldNote{"f_number", "", 0.8, 16, "Focal length over aperture.", "PlayStation Eye: 2.1"}, c.f_number);
  visit(FieldNote{"transmission", "", 0.1, 1, "Light that passes the glass.", "coated lens of few elements: 0.9"},
        c.transmission);
  visit(FieldNote{"vignetting_exponent", "", 0, 10, "n of the fall-off cos^n with the field angle.",
                  "cos^4 law of a thin lens; more where barrels cut"},
        c.vignetting_exponent);
  visit(FieldNote{"circle_fraction", "", 0.3, 10,
                  "Image circle's radius over half the frame's diagonal; from 1.2: unseen.",
                  "wide lenses on larger sensors"},
        c.circle_fraction);
  visit(FieldNote{"blur_px", "px", 0, 0.8, "Standard deviation of the lens's blur.", "low-cost lenses: 0.5 to 0.8"},
        c.blur_px);
  visit(FieldNote{"glare", "", 0, 20, "L = glare * E / angle_deg^2 about lamps in sight.",
                  "CIE 146: 10 for the eye; clean lenses less"},
        c.glare);
  visit(FieldNote{"focus_m", "m", 0.1, 1000, "Distance in focus.", "fixed-focus cameras: hyperfocal"}, c.focus_m);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, DirtConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"spots", "", 0, 20, "Spots of dirt on the front glass; those after the first lie anywhere.",
                  "0: a clean lens"},
        c.spots);
  visit(FieldNote{"azimuth_deg", "deg", -60, 60, "Place of the first, positive to the right.", "any"}, c.azimuth_deg);
  visit(FieldNote{"elevation_deg", "deg", -60, 60, "Place of the first.", "any"}, c.elevation_deg);
  visit(FieldNote{"radius_deg", "deg", 0.5, 40, "To where half of the opacity is reached.",
                  "a splash of 3 mm, 15 mm before the aperture: 6"},
        c.radius_deg);
  visit(FieldNote{"edge_deg", "deg", 0.1, 40, "Width of its soft edge, within and beyond the radius.",
                  "aperture over distance: 0.8 mm of a small camera at 15 mm is 3"},
        c.edge_deg);
  visit(FieldNote{"opacity", "", 0, 1, "Light that the middle of a spot takes away.", "mud: all; a film of oil: 0.3"},
        c.opacity);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, SensorConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"pixel_pitch_um", "um", 1, 20, "Side of a pixel.", "OV7720 of the PlayStation Eye: 6.0"},
        c.pixel_pitch_um);
  visit(FieldNote{"quantum_efficiency", "", 0.01, 1, "Electrons a photon in green, filter included.",
                  "CMOS of 2007 with colour filter: 0.3 to 0.4"},
        c.quantum_efficiency);
  visit(FieldNote{"response_red", "", 0.05, 3, "Red relative to green.", "colour filters under white LEDs"},
        c.response_red);
  visit(FieldNote{"response_blue", "", 0.05, 3, "Blue relative to green.", "colour filters under white LEDs"},
        c.response_blue);
  visit(FieldNote{"white_red", "", 0.25, 4, "White balance: gain of red.", "1 / response_red; OV7725: within 12 dB"},
        c.white_red);
  visit(FieldNote{"white_blue", "", 0.25, 4, "White balance: gain of blue.", "1 / response_blue; OV7725: within 12 dB"},
        c.white_blue);
  visit(FieldNote{"full_well_e", "e-", 500, 200000, "Electrons of white at gain 1.", "some hundred e- a square micron"},
        c.full_well_e);
  visit(FieldNote{"read_noise_e", "e-", 0, 100, "Noise of a pixel in the dark, before the amplifier.",
                  "rolling-shutter CMOS of 2007: 5 to 10 e-"},
        c.read_noise_e);
  visit(FieldNote{"converter_noise_e", "e-", 0, 200, "Noise behind the amplifier: divided by the gain.",
                  "OV7725: dynamic range 60 dB, both noises together at gain 1"},
        c.converter_noise_e);
  visit(FieldNote{"row_noise_e", "e-", 0, 50, "Offset that a row shares.",
                  "banding of dark frames: a tenth of read noise"},
        c.row_noise_e);
  visit(FieldNote{"pattern_noise_e", "e-", 0, 50, "Offset of a pixel that stays.", "EMVA 1288 DSNU of low-cost CMOS"},
        c.pattern_noise_e);
  visit(
      FieldNote{"response_spread_fraction", "", 0, 0.2, "Spread of the pixels' sensitivities.", "EMVA 1288 PRNU: 1 %"},
      c.response_spread_fraction);
  visit(FieldNote{"adc_bits", "bit", 8, 14, "Of the converter.", "OV7725: 10"}, c.adc_bits);
  visit(FieldNote{"exposure_min_s", "s", 0.000001, 0.1, "Shortest exposure.", "some rows' time"}, c.exposure_min_s);
  visit(FieldNote{"exposure_max_s", "s", 0.00001, 1, "Longest exposure.", "below the frame's period of 33 ms"},
        c.exposure_max_s);
  visit(FieldNote{"colour_fade_gain", "", 1, 1000,
                  "Gain at which half of the colour is taken away, against coloured noise.",
                  "OV7725: automatic UV adjustment"},
        c.colour_fade_gain);
  visit(FieldNote{"gain_max", "", 1, 64, "Largest analogue gain.", "OV7725: 30 dB; used to 8 for noise's sake"},
        c.gain_max);
  visit(FieldNote{"exposure_target_level", "level", 5, 250, "Mean level auto exposure goes for.",
                  "frames of lamp-lit caves: 40 to 90"},
        c.exposure_target_level);
  visit(FieldNote{"exposure_speed", "", 0, 1, "Share of the way gone from frame to frame; 0: exposure stays.",
                  "settles in about ten frames, as on the OV7725"},
        c.exposure_speed);
  visit(FieldNote{"gamma", "", 1, 3, "Tone curve: level ~ light^(1 / gamma).", "sRGB: about 2.2"}, c.gamma);
  visit(FieldNote{"readout_s", "s", 0, 0.2, "From the first row to the last; 0: global shutter.",
                  "rolling shutter at 30 frames a second: up to 33 ms"},
        c.readout_s);
  visit(FieldNote{"jpeg_quality", "", 0, 100, "Of the stream; 0: no JPEG.", "USB and recorded streams: 75 to 90"},
        c.jpeg_quality);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, RenderConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"threads", "", 0, 1024, "Threads; 0: all. The bytes do not depend on it.", "the machine"}, c.threads);
  visit(FieldNote{"virtual_lights", "", 0, 256, "Points that stand for light reflected once; 0: none.",
                  "Keller 1997; 16 keep up with 30 frames a second"},
        c.virtual_lights);
  visit(FieldNote{"indirect_clamp_m", "m", 0.05, 10, "Virtual lights come no closer than this.",
                  "a fifth of a passage's width"},
        c.indirect_clamp_m);
  visit(
      FieldNote{"shadows", "", 0, 1, "Whether lamps cast shadows.", "chosen: rock casts them; off to see what they do"},
      c.shadows);
  visit(
      FieldNote{"facets", "", 0, 1, "Facets and patches finer than the mesh.", "chosen: rock has them; off for speed"},
      c.facets);
  visit(FieldNote{"motion_blur", "", 0, 1, "Blur along the flow within the exposure.",
                  "chosen: cameras have it; off to see frames without"},
        c.motion_blur);
  visit(FieldNote{"sensor_noise", "", 0, 1, "Photon, read, row and pattern noise.",
                  "chosen: cameras have it; off for closed forms in tests"},
        c.sensor_noise);
  visit(
      FieldNote{"foreign_red", "", 0.1, 3, "Red of lamps in the world, relative to green.", "halogen and sodium: warm"},
      c.foreign_red);
  visit(FieldNote{"foreign_blue", "", 0.1, 3, "Blue of lamps in the world, relative to green.",
                  "halogen and sodium: warm"},
        c.foreign_blue);
  visit(FieldNote{"cull_fraction", "", 0, 0.1, "Lamps below this share of white are passed over in a tile.",
                  "under a tenth of the darkest level of 8 bits"},
        c.cull_fraction);
}

}  // namespace adit::sim
