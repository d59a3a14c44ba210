// One labelled picture of everything the finder did to a frame: Figures 1 and 2 of the paper, for your frame.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "adit/finder.hpp"

namespace adit::io {

/// What the panel is about.
struct PanelSubject {
  std::string name;      ///< of the frame, for the title
  cv::Mat frame;         ///< any frame that bgr_of() takes
  OpenSpace open_space;  ///< of OpenSpaceFinder::explain(frame, stages)
  StageImages stages;    ///< of the same call; stages that were not reached are drawn as empty boxes
  FinderConfig config;   ///< the finder's
  bool has_camera;       ///< a calibration was given; else the bearing comes from the assumed pinhole
};

/// Draws, from the top: the title and the verdict; Fig. 2 (frame and depth map, each with the red circle); Fig. 1 (each
/// stage as a picture, with its equation); the histogram with the limits of the clusters; the figures.
/// 8-bit BGR, 1920 px wide whatever the frame's size; the height follows the frame's shape.
/// @throws std::invalid_argument for a frame that bgr_of() does not take.
[[nodiscard]] cv::Mat explain_panel(const PanelSubject& subject);

}  // namespace adit::io
