// Lens and sensor: from luminance in front of the lens to the bytes of a frame.
#pragma once

#include "adit/camera.hpp"

namespace adit::sim {

/// Where the camera sits on the body, and its lens.
struct LensConfig {
  int width = 640;   ///< px
  int height = 480;  ///< px
  float hfov_deg = 75.0f;
  float k1 = 0.0f, k2 = 0.0f, p1 = 0.0f, p2 = 0.0f, k3 = 0.0f;  ///< plumb_bob
  float forward_m = 0.10f;                                      ///< place in the body frame
  float left_m = 0.0f;
  float up_m = 0.0f;
  float pitch_deg = 0.0f;  ///< positive up
  float f_number = 2.1f;
  float transmission = 0.9f;
  float vignetting_exponent = 4.0f;  ///< fall-off as cos^n of the field angle
  float circle_fraction = 2.0f;      ///< radius of the lens's image circle over half the diagonal; >= 1.2: not seen
  float blur_px = 0.6f;              ///< standard deviation of the lens's blur
  float glare = 1.0f;                ///< L = glare * E / angle_deg^2 about a lamp in sight
  float focus_m = 3.0f;              ///< distance in focus; grains near the lens become discs
};

/// Spots on the front glass, far out of focus. The glass turns with the camera, so they stand still in the frame.
struct DirtConfig {
  int spots = 0;             ///< 0: clean; those after the first lie anywhere in the frame, always at the same places
  float azimuth_deg = 0.0f;  ///< place of the first, positive to the right
  float elevation_deg = 0.0f;
  float radius_deg = 6.0f;  ///< to where half of the opacity is reached
  float edge_deg = 3.0f;    ///< width of the soft edge: the angle under which the glass sees the aperture
  float opacity = 0.97f;    ///< share of the light that the middle of a spot takes away
};

/// The sensor, its amplifier and what the camera's processor makes of it.
struct SensorConfig {
  float pixel_pitch_um = 6.0f;
  float quantum_efficiency = 0.35f;  ///< electrons a photon in green, colour filter included
  float response_red = 0.75f;        ///< red relative to green
  float response_blue = 0.65f;       ///< blue relative to green
  float white_red = 1.33f;           ///< gain of the white balance
  float white_blue = 1.54f;
  float full_well_e = 10000.0f;
  float read_noise_e = 6.0f;               ///< before the amplifier
  float converter_noise_e = 10.0f;         ///< after it: gain makes it small beside the light
  float row_noise_e = 1.5f;                ///< offset that a row shares: banding
  float pattern_noise_e = 1.5f;            ///< offset of a pixel that stays from frame to frame
  float response_spread_fraction = 0.01f;  ///< spread of the pixels' sensitivities
  int adc_bits = 10;
  float exposure_min_s = 0.0001f;
  float exposure_max_s = 0.025f;
  float colour_fade_gain = 8.0f;        ///< gain at which the camera takes half of the colour away
  float gain_max = 16.0f;               ///< at gain 1 the full well is white
  float exposure_target_level = 80.0f;  ///< mean of the frame that auto exposure goes for
  float exposure_speed = 0.35f;         ///< share of the way gone from frame to frame; 0: exposure stays
  float gamma = 2.2f;
  float readout_s = 0.025f;  ///< from the first row to the last (rolling shutter); 0: global shutter
  int jpeg_quality = 0;      ///< 0: no JPEG
};

/// What auto exposure sets.
struct Exposure {
  float time_s = 0.01f;
  float gain = 1.0f;
};

/// The camera's own loop: it sees a frame's mean and sets the next exposure. Time first, then gain.
class AutoExposure {
 public:
  explicit AutoExposure(const SensorConfig& sensor, Exposure start = {0.01f, 2.0f});
  [[nodiscard]] Exposure current() const noexcept { return current_; }
  /// @param mean_level of the last frame, 0 to 255.
  void observe(float mean_level) noexcept;

 private:
  SensorConfig sensor_;
  Exposure current_;
};

/// The core's camera for a lens: pinhole with plumb_bob distortion.
[[nodiscard]] CameraModel camera_model(const LensConfig& lens);

/// Electrons in green per cd/m^2 of luminance and second of exposure, on the axis:
/// pi/4 * transmission / f_number^2 lux per cd/m^2; 1 lm at 555 nm is 1/683 W or 4.09e15 photons a second.
[[nodiscard]] float electrons_per_luminance_second(const LensConfig& lens, const SensorConfig& sensor);

}  // namespace adit::sim
