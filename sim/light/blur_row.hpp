// Motion blur as a row loop. Plain memory only, so that one source compiles for every CPU target.
#pragma once

#include <cstddef>

namespace adit::sim {

inline constexpr int kBlurTapsMax = 16;

/// One row of the frame, blurred along the flow of what it sees.
struct BlurRow {
  const float* run_directions[3];  ///< optical frame, of the middles of this row's runs
  const float* range;              ///< of this row
  const float* planes[3];          ///< of the frame, `stride` floats a row
  float* blurred[3];               ///< out: this row
  float turn_rate_rad_s[3];        ///< optical frame
  float velocity_m_s[3];
  float focal_x_px, focal_y_px;
  float time_s;
  int row, width, height, stride;
};

}  // namespace adit::sim
