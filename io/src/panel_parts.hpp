// The parts of the panel of `adit explain`, each drawn into its own box.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "adit/io/panel.hpp"
#include "adit/io/stage_tiles.hpp"
#include "lettering.hpp"

namespace adit::io {

// The panel's colours (BGR).
inline const cv::Scalar kPaper(30, 26, 24);
inline const cv::Scalar kSheet(44, 39, 36);
inline const cv::Scalar kInk(238, 236, 234);
inline const cv::Scalar kFaint(165, 158, 152);
inline const cv::Scalar kEmpty(58, 52, 48);
inline const cv::Scalar kGood(110, 190, 80);
inline const cv::Scalar kBad(60, 80, 225);
inline const cv::Scalar kCircle(40, 40, 255);

/// The colour of a cluster: 0, the darkest, is red; the others go from violet to yellow.
[[nodiscard]] cv::Scalar colour_of_cluster(int cluster, int cluster_count);

/// The histogram of the closed dark channel, with a stripe for each cluster and a line at each limit.
void draw_histogram(cv::Mat& panel, cv::Rect box, const PanelSubject& subject);

/// All numbers of the result, in columns of names and values.
void draw_figures(cv::Mat& panel, cv::Rect box, const PanelSubject& subject);

/// Puts a picture into a box, whole and in the middle, and returns where it went.
cv::Rect place(cv::Mat& panel, cv::Rect box, const cv::Mat& picture);

}  // namespace adit::io
