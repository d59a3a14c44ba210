// Pictures for people: the frame with its answer, and the depth map beside it (paper, Fig. 2).
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "adit/finder.hpp"
#include "adit/heading.hpp"

namespace adit::io {

/// A frame as BGR, 8 bits, in pixels of its own: what the drawing functions draw on. Never shares memory with `frame`.
/// @param frame  8-bit with 1, 3 or 4 channels (grey, BGR, BGRA), or 16-bit grey.
/// @param grey16_depth_bits  8 to 16, as FinderConfig::grey16_depth_bits; looked at only for 16-bit frames.
/// @throws std::invalid_argument for an empty frame or another type.
[[nodiscard]] cv::Mat bgr_of(const cv::Mat& frame, int grey16_depth_bits = 16);

/// Draws the answer into a frame: the paper's red circle at the centroid, the commanded turn as an arrow at the foot
/// (length: share of 1 rad/s), status, confidence and bearing in words. A frame without an opening gets a banner that
/// says so and why, and no circle. Lettering and lines scale with the frame; on frames too small for a line of text
/// the text is left out.
/// @param bgr  8-bit, 3 channels, any size. @throws std::invalid_argument for anything else.
/// @param command  what the vehicle is told; nothing for single pictures.
void draw_overlay(cv::Mat& bgr, const OpenSpace& open_space, std::optional<HeadingCommand> command);

/// The scattering depth in colour, 8-bit BGR, of the frame's size: black and violet is far, yellow is near (the
/// polarity of the lamp-lit tunnel: the smallest depth is the farthest place). An even grey where no depth was made.
/// The scale runs from the frame's smallest to its largest closed depth, as its square root: the dark end is where the
/// openings are, and the bright floor would take the colours from it.
[[nodiscard]] cv::Mat depth_map(const StageImages& stages);

/// Fig. 2 of the paper: the frame with its overlay on the left, the closed depth map with the same circle on the right,
/// with a scale that says which colour is far. Both halves have the frame's size; the width is even for video encoders.
/// @param frame  any frame that bgr_of() takes.
[[nodiscard]] cv::Mat side_by_side(const cv::Mat& frame, const OpenSpace& open_space, const StageImages& stages,
                                   std::optional<HeadingCommand> command);

}  // namespace adit::io
