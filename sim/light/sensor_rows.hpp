// What the sensor's row loops work on.
#pragma once

#include <cstdint>

namespace adit::sim {

inline constexpr int kGaussSteps = 4096;

/// Luminance rows -> digital numbers behind the colour mosaic (red green / green blue).
struct MosaicRow {
  const float* above[2];  ///< luminance, cd/m^2, of the two colours of this row: of even columns, of odd columns
  const float* here[2];
  const float* below[2];
  float* scratch[2];             ///< width + 2 floats each
  float blur_centre, blur_side;  ///< three-tap kernel of the lens's blur, in both directions
  const float* sensitivity;      ///< electrons per cd/m^2 and second: lens, vignetting, spread of the pixels
  const float* offset_e;         ///< fixed pattern
  float response[2];             ///< of the two colours, times exposure time
  float full_well_e, read_variance_e2, row_offset_e;
  float numbers_per_e, number_max;
  float noise;         ///< 1, or 0 for a noiseless sensor
  std::uint32_t seed;  ///< of this row of this frame
  const float* gauss;  ///< kGaussSteps quantiles of the standard normal
  float* mosaic;       ///< out: digital numbers, 0 to number_max
  int width;
};

/// Mosaic rows -> bytes.
struct ToneRow {
  const float* above;
  const float* here;
  const float* below;  ///< mosaic rows; all three readable from -1 to width
  bool odd_row;
  float white_red, white_blue;
  float colour;  ///< share of the colour that is kept
  float number_max;
  const std::int32_t* tone;  ///< number_max + 1 bytes
  std::uint32_t* scratch;    ///< width
  std::uint8_t* bgr;
  std::uint64_t* level_sum;  ///< out: sum over the row's bytes
  int width;
};

}  // namespace adit::sim
