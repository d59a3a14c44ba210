// The figures of a method over a set of frames.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "adit/eval/bootstrap.hpp"
#include "adit/eval/score.hpp"

namespace adit::eval {

/// A frame's score, and where and when the frame was taken.
struct ScoredFrame {
  FrameScore score;
  int place = 0;         ///< any number
  int sequence = -1;     ///< frames of one number follow each other in time, in the order given; -1: alone
  double yaw_rad = 0.0;  ///< of the camera, counter-clockwise, where it is known: taken off the jitter
};

enum class Figure {
  kHitRate,           ///< hits over open frames; a refusal is no hit
  kRefusedOpen,       ///< open frames refused: wrong
  kRefusedNone,       ///< frames without an opening refused: right
  kError,             ///< deg, median over answers on open frames, to the nearest opening
  kDeepestError,      ///< the same to the deepest direction
  kPassageError,      ///< the same to the passage, azimuth alone
  kOpenRatio,         ///< mean over answers on open frames
  kCalibrationError,  ///< over answers with a confidence, on open frames and such without an opening
  kJitter,            ///< deg, mean change of azimuth between neighbours of a sequence that were both answered
  kBranchRecall,      ///< true openings named, over all, on frames with two or more
  kBranchPrecision,   ///< named openings that are true, over all named, on such frames
};
inline constexpr int kFigureCount = 11;
/// "hit_rate", "refused_open", "refused_none", "error_deg", ...: names of columns.
[[nodiscard]] std::string_view to_string(Figure figure) noexcept;

struct Estimate {
  double value = kUnknown;           ///< NaN: the set has nothing to measure it on
  std::optional<Interval> interval;  ///< nothing: it cannot be told
};

struct Figures {
  int frames = 0;
  int places = 0;  ///< that occur
  int open = 0;
  int none = 0;
  int hits = 0;
  int refused_none = 0;  ///< frames, as hits
  std::array<Estimate, kFigureCount> estimates;
  std::vector<ReliabilityBin> reliability;  ///< empty without confidences

  [[nodiscard]] const Estimate& operator[](Figure figure) const { return estimates[static_cast<std::size_t>(figure)]; }
};

/// @throws std::invalid_argument for a BootstrapConfig that Bootstrap refuses.
[[nodiscard]] Figures figures_of(const std::vector<ScoredFrame>& frames, const BootstrapConfig& config);

/// Change of the heading from one frame to the next, rad, positive. @return NaN unless both were answered.
[[nodiscard]] double heading_change_rad(const ScoredFrame& from, const ScoredFrame& to) noexcept;

}  // namespace adit::eval
