// The stages of one frame as pictures with captions: the tiles of Fig. 1.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "adit/io/panel.hpp"

namespace adit::io {

/// One stage of Fig. 1: a picture of the frame's size (empty if the stage was not reached) and its captions.
struct StageTile {
  cv::Mat picture;
  std::string name;
  std::string equation;
  std::string note;
};

/// The frame and the stages, in order; as many for every frame of a method.
/// @throws std::invalid_argument for a frame that bgr_of() does not take.
[[nodiscard]] std::vector<StageTile> stage_tiles(const PanelSubject& subject);

}  // namespace adit::io
