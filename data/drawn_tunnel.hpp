// A lamp-lit drift in rock, drawn from formulas: the stand-in for footage in the shipped clip, the demo and the bench.
#pragma once

#include <opencv2/core/mat.hpp>

namespace adit::drawn {

/// The clip: frames of 640 x 480 px, 30 a second.
inline constexpr int kFrameCount = 60;
inline constexpr double kRate_hz = 30.0;
inline constexpr int kWidth_px = 640;
inline constexpr int kHeight_px = 480;
inline constexpr double kHfov_deg = 75.0;

/// Frame `index` (0 to kFrameCount - 1) of a flight through an S-bend: 8-bit BGR, width x height px. The same on every
/// run. Rock with relief, two lamps beside the camera (inverse square, Lambert), vignetting, shot and read noise.
/// About a second for 640 x 480 on one core.
[[nodiscard]] cv::Mat tunnel_frame(int index, int width, int height);

}  // namespace adit::drawn
