// What the gallery shows of a frame besides its answers.
#pragma once

#include <opencv2/core/mat.hpp>

#include "eval_work.hpp"

namespace adit::tools {

/// Adds thumbnail, open area and bearings of truth, all in pixels of the frame.
void add_pictures(const cv::Mat& pixels, const eval::FrameTruth& truth, const Camera& camera,
                  const eval::ScoreConfig& config, JudgedFrame& judged);

}  // namespace adit::tools
