// One frame, one answer: was it right? Everything here is a definition; docs/benchmark.md gives them as formulas.
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "adit/camera.hpp"
#include "adit/eval/outline.hpp"

namespace adit::eval {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Range along the ray of each pixel, rows one after the other.
struct RangeImage {
  int width = 0;
  int height = 0;
  std::vector<float> range_m;  ///< empty: none is known

  /// Of the pixel whose area holds the place; NaN outside the image or without ranges.
  [[nodiscard]] double at(Pixel place) const noexcept;
};

/// The 99th percentile of range (nearest rank); NaN without ranges. Not the largest: one pixel through a crack is no
/// passage.
[[nodiscard]] double far_range_m(const RangeImage& image);

/// What a frame shows.
enum class Scene {
  kOpen,       ///< at least one opening
  kNone,       ///< none: the only right answer is a refusal
  kUndecided,  ///< both a heading and a refusal can be defended: not counted
};

/// What is known of a frame. Marked frames have outlines, rendered ones have bearings and ranges.
struct FrameTruth {
  Scene scene = Scene::kUndecided;
  std::vector<Outline> outlines;
  std::vector<Bearing> branches;   ///< passages that go on and are in sight, in the frame
  std::optional<Bearing> passage;  ///< the way that is followed, in sight too; one of the branches or their stem
  std::optional<Bearing> deepest;  ///< direction of the longest range
  RangeImage ranges;
  double far_m = kUnknown;  ///< far_range_m(ranges)
};

/// The constants of the definitions.
struct ScoreConfig {
  /// Open ratio from which an answer on a rendered frame is a hit: nearer to the far end than to the camera.
  double open_ratio_min = 0.5;
  /// An answer so close to a passage in sight is a hit whatever lies behind it: in a bend that is the outer wall. Half
  /// the angle that a passage of 3.5 m has at 20 m, as far as branches are looked for.
  double branch_hit_deg = 5.0;
  /// An answered opening so close to a branch is that branch: half the angle of a mouth of 4 m at 11 m.
  double branch_match_deg = 10.0;
  /// A rendered frame whose longest range is below this, and in which nothing goes on, shows no opening
  /// (truth.opening_range_min_m of the simulator).
  double opening_range_min_m = 4.0;
  /// A rendered frame without a passage that goes on (the far side of a chamber, a dead end from afar) counts as open
  /// from this range on; between the two it is undecided. Twice the above.
  double open_range_m = 8.0;
};

/// What a method said of a frame.
struct Answer {
  bool found = false;
  Pixel place;                   ///< when found
  double confidence = kUnknown;  ///< 0 to 1; NaN: the method gives none
  std::vector<Pixel> openings;   ///< all that it names, the best first; may be empty
};

enum class Verdict {
  kHit,           ///< open, and the answer lies in the opening
  kMiss,          ///< open, and the answer lies elsewhere
  kRefusedOpen,   ///< open, and no answer: wrong
  kRefusedNone,   ///< no opening, and no answer: right
  kAnsweredNone,  ///< no opening, and an answer: wrong
  kNotCounted,    ///< undecided
};
inline constexpr int kVerdictCount = 6;
/// "hit", "miss", "refused_open", "refused_none", "answered_none", "not_counted".
[[nodiscard]] std::string_view to_string(Verdict verdict) noexcept;
[[nodiscard]] constexpr bool is_right(Verdict verdict) noexcept {
  return verdict == Verdict::kHit || verdict == Verdict::kRefusedNone;
}

/// What came of it. Figures that do not exist are NaN.
struct FrameScore {
  Verdict verdict = Verdict::kNotCounted;
  bool answered = false;
  double confidence = kUnknown;         ///< when answered
  double azimuth_rad = kUnknown;        ///< of the answer
  double open_ratio = kUnknown;         ///< 0 to 1
  double error_rad = kUnknown;          ///< to the nearest opening: outline, passage, branch, deepest direction
  double deepest_error_rad = kUnknown;  ///< to the deepest direction
  double passage_error_rad = kUnknown;  ///< to the passage, azimuth alone
  int branches = 0;                     ///< openings in sight, where there are two or more; else 0
  int branches_found = 0;               ///< of these, named
  int named = 0;                        ///< openings named on such a frame
  int named_right = 0;                  ///< of these, true ones
};

/// The angle between two directions, rad, 0 to pi.
[[nodiscard]] double angle_between(Bearing a, Bearing b) noexcept;

/// What a rendered frame shows, from its longest range and whether a passage or branch is in sight.
[[nodiscard]] Scene scene_of(double deepest_range_m, bool goes_on, const ScoreConfig& config) noexcept;

[[nodiscard]] FrameScore score_of(const FrameTruth& truth, const Answer& answer, const Camera& camera,
                                  const ScoreConfig& config);

}  // namespace adit::eval
