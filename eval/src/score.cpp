#include "adit/eval/score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace adit::eval {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFarShare = 0.99;

std::array<double, 3> direction_of(Bearing b) noexcept {
  const double c = std::cos(b.elevation_rad);
  return {c * std::sin(b.azimuth_rad), std::sin(b.elevation_rad), c * std::cos(b.azimuth_rad)};
}

/// To the nearest way on: the passage that is followed, and the branches.
double nearest_way_rad(const FrameTruth& truth, Bearing bearing) noexcept {
  double best = truth.passage ? angle_between(*truth.passage, bearing) : kUnknown;
  for (const Bearing& branch : truth.branches) best = std::fmin(best, angle_between(branch, bearing));
  return best;
}

/// To the nearest outline, 0 inside.
double nearest_outline_rad(const std::vector<Outline>& outlines, Pixel place, const Camera& camera) noexcept {
  const Bearing bearing = camera.bearing_of(place);
  double best = kUnknown;
  for (const Outline& outline : outlines) {
    if (contains(outline, place)) return 0.0;
    best = std::fmin(best, angle_between(camera.bearing_of(nearest_of(outline, place)), bearing));
  }
  return best;
}

bool is_hit(const FrameTruth& truth, Pixel place, const Camera& camera, double open_ratio,
            const ScoreConfig& config) noexcept {
  if (!truth.outlines.empty())
    return std::any_of(truth.outlines.begin(), truth.outlines.end(),
                       [place](const Outline& outline) { return contains(outline, place); });
  // Comparisons with NaN are false: what is not known is no hit.
  return open_ratio >= config.open_ratio_min ||
         nearest_way_rad(truth, camera.bearing_of(place)) <= config.branch_hit_deg * kDegree;
}

Verdict verdict_of(Scene scene, bool answered, bool hit) noexcept {
  switch (scene) {
    case Scene::kOpen:
      return !answered ? Verdict::kRefusedOpen : hit ? Verdict::kHit : Verdict::kMiss;
    case Scene::kNone:
      return answered ? Verdict::kAnsweredNone : Verdict::kRefusedNone;
    case Scene::kUndecided:
      break;
  }
  return Verdict::kNotCounted;
}

/// Pairs named openings with true ones, each at most once, in the order named.
void count_branches(const FrameTruth& truth, const Answer& answer, const Camera& camera, const ScoreConfig& config,
                    FrameScore& score) {
  const bool marked = !truth.outlines.empty();
  const std::size_t count = marked ? truth.outlines.size() : truth.branches.size();
  if (count < 2 || truth.scene != Scene::kOpen) return;
  score.branches = static_cast<int>(count);
  if (!answer.found) return;
  const std::vector<Pixel> named = answer.openings.empty() ? std::vector<Pixel>{answer.place} : answer.openings;
  std::vector<bool> taken(count, false);
  for (const Pixel place : named) {
    ++score.named;
    std::size_t best = count;
    double best_rad = marked ? 0.0 : config.branch_match_deg * kDegree;
    for (std::size_t i = 0; i < count; ++i) {
      if (taken[i]) continue;
      const double away_rad = marked ? (contains(truth.outlines[i], place) ? 0.0 : kUnknown)
                                     : angle_between(truth.branches[i], camera.bearing_of(place));
      if (away_rad <= best_rad) {
        best_rad = away_rad;
        best = i;
      }
    }
    if (best == count) continue;
    taken[best] = true;
    ++score.branches_found;
    ++score.named_right;
  }
}

/// (-pi, pi]
double wrapped(double angle_rad) noexcept { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

}  // namespace

double RangeImage::at(Pixel place) const noexcept {
  const double u = std::round(place.u_px), v = std::round(place.v_px);
  if (range_m.empty() || !(u >= 0.0 && v >= 0.0 && u < width && v < height)) return kUnknown;
  return static_cast<double>(
      range_m[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)]);
}

double far_range_m(const RangeImage& image) {
  if (image.range_m.empty()) return kUnknown;
  std::vector<float> sorted = image.range_m;
  const auto rank = static_cast<std::size_t>(std::ceil(kFarShare * static_cast<double>(sorted.size())));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(sorted.begin(), nth, sorted.end());
  return static_cast<double>(*nth);
}

std::string_view to_string(Verdict verdict) noexcept {
  constexpr std::array<std::string_view, kVerdictCount> kNames{"hit",          "miss",          "refused_open",
                                                               "refused_none", "answered_none", "not_counted"};
  return kNames[static_cast<std::size_t>(verdict)];
}

double angle_between(Bearing a, Bearing b) noexcept {
  const auto p = direction_of(a), q = direction_of(b);
  const double x = p[1] * q[2] - p[2] * q[1], y = p[2] * q[0] - p[0] * q[2], z = p[0] * q[1] - p[1] * q[0];
  // The arc cosine alone loses half the digits where the angle is small, which is where it matters.
  return std::atan2(std::sqrt(x * x + y * y + z * z), p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
}

Scene scene_of(double deepest_range_m, bool goes_on, const ScoreConfig& config) noexcept {
  if (deepest_range_m >= config.open_range_m) return Scene::kOpen;
  if (deepest_range_m >= config.opening_range_min_m) return goes_on ? Scene::kOpen : Scene::kUndecided;
  return goes_on ? Scene::kUndecided : Scene::kNone;
}

FrameScore score_of(const FrameTruth& truth, const Answer& answer, const Camera& camera, const ScoreConfig& config) {
  FrameScore score;
  score.answered = answer.found;
  bool hit = false;
  if (answer.found) {
    const Bearing bearing = camera.bearing_of(answer.place);
    score.azimuth_rad = bearing.azimuth_rad;
    score.confidence = answer.confidence;
    if (const double range_m = truth.ranges.at(answer.place); truth.far_m > 0.0)
      score.open_ratio = std::isnan(range_m) ? kUnknown : std::min(range_m / truth.far_m, 1.0);
    score.error_rad = truth.outlines.empty() ? nearest_way_rad(truth, bearing)
                                             : nearest_outline_rad(truth.outlines, answer.place, camera);
    if (truth.deepest) {
      score.deepest_error_rad = angle_between(*truth.deepest, bearing);
      score.error_rad = std::fmin(score.error_rad, score.deepest_error_rad);
    }
    if (truth.passage) score.passage_error_rad = std::abs(wrapped(bearing.azimuth_rad - truth.passage->azimuth_rad));
    hit = is_hit(truth, answer.place, camera, score.open_ratio, config);
  }
  score.verdict = verdict_of(truth.scene, answer.found, hit);
  count_branches(truth, answer, camera, config, score);
  return score;
}

}  // namespace adit::eval
