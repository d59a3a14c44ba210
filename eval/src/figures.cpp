#include "adit/eval/figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace adit::eval {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
using Statistic = std::function<double(PlaceWeights)>;
using Samples = std::vector<Sample>;

bool is_open(Verdict v) { return v == Verdict::kHit || v == Verdict::kMiss || v == Verdict::kRefusedOpen; }
bool is_none(Verdict v) { return v == Verdict::kRefusedNone || v == Verdict::kAnsweredNone; }

/// A sample of each frame for which value() gives a number.
template <class Value>
Samples samples_of(const std::vector<ScoredFrame>& frames, Value&& value) {
  Samples samples;
  for (const ScoredFrame& frame : frames)
    if (const double v = value(frame.score); !std::isnan(v)) samples.push_back({v, 1.0, frame.place});
  return samples;
}

Statistic mean(Samples samples) {
  return [samples = std::move(samples)](PlaceWeights weights) { return mean_of(samples, weights); };
}

Statistic median(Samples samples) {
  std::stable_sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.value < b.value; });
  return [samples = std::move(samples)](PlaceWeights weights) { return median_of(samples, weights); };
}

/// The share of frames of a kind with a verdict.
Statistic share(const std::vector<ScoredFrame>& frames, bool (*kind)(Verdict), Verdict verdict) {
  return mean(samples_of(frames, [=](const FrameScore& s) {
    return !kind(s.verdict) ? kUnknown : s.verdict == verdict ? 1.0 : 0.0;
  }));
}

/// A figure of the answers on open frames.
Samples of_open(const std::vector<ScoredFrame>& frames, double FrameScore::*member, double unit) {
  return samples_of(frames, [=](const FrameScore& s) { return is_open(s.verdict) ? s.*member / unit : kUnknown; });
}

Samples ratio(const std::vector<ScoredFrame>& frames, int FrameScore::*part, int FrameScore::*whole) {
  Samples samples;
  for (const ScoredFrame& f : frames)
    if (f.score.*whole > 0)
      samples.push_back({static_cast<double>(f.score.*part), static_cast<double>(f.score.*whole), f.place});
  return samples;
}

std::vector<Claim> claims_of(const std::vector<ScoredFrame>& frames) {
  std::vector<Claim> claims;
  for (const ScoredFrame& f : frames)
    if (f.score.answered && f.score.verdict != Verdict::kNotCounted && !std::isnan(f.score.confidence))
      claims.push_back({f.score.confidence, is_right(f.score.verdict), f.place});
  return claims;
}

Samples changes_of(const std::vector<ScoredFrame>& frames) {
  Samples samples;
  std::map<int, const ScoredFrame*> before;
  for (const ScoredFrame& frame : frames) {
    if (frame.sequence < 0) continue;
    const ScoredFrame*& last = before[frame.sequence];
    if (last != nullptr)
      if (const double change = heading_change_rad(*last, frame); !std::isnan(change))
        samples.push_back({change / kDegree, 1.0, frame.place});
    last = &frame;
  }
  return samples;
}

Statistic statistic_of(Figure figure, const std::vector<ScoredFrame>& frames) {
  switch (figure) {
    case Figure::kHitRate:
      return share(frames, is_open, Verdict::kHit);
    case Figure::kRefusedOpen:
      return share(frames, is_open, Verdict::kRefusedOpen);
    case Figure::kRefusedNone:
      return share(frames, is_none, Verdict::kRefusedNone);
    case Figure::kError:
      return median(of_open(frames, &FrameScore::error_rad, kDegree));
    case Figure::kDeepestError:
      return median(of_open(frames, &FrameScore::deepest_error_rad, kDegree));
    case Figure::kPassageError:
      return median(of_open(frames, &FrameScore::passage_error_rad, kDegree));
    case Figure::kOpenRatio:
      return mean(of_open(frames, &FrameScore::open_ratio, 1.0));
    case Figure::kCalibrationError:
      return [claims = claims_of(frames)](PlaceWeights weights) { return calibration_error_of(claims, weights); };
    case Figure::kJitter:
      return mean(changes_of(frames));
    case Figure::kBranchRecall:
      return mean(ratio(frames, &FrameScore::branches_found, &FrameScore::branches));
    case Figure::kBranchPrecision:
      return mean(ratio(frames, &FrameScore::named_right, &FrameScore::named));
  }
  return [](PlaceWeights) { return kUnknown; };
}

}  // namespace

std::string_view to_string(Figure figure) noexcept {
  constexpr std::array<std::string_view, kFigureCount> kNames{
      "hit_rate",   "refused_open",      "refused_none", "error_deg",     "deepest_error_deg", "passage_error_deg",
      "open_ratio", "calibration_error", "jitter_deg",   "branch_recall", "branch_precision"};
  return kNames[static_cast<std::size_t>(figure)];
}

double heading_change_rad(const ScoredFrame& from, const ScoredFrame& to) noexcept {
  // Azimuth is to the right, yaw to the left: the heading in the world is yaw - azimuth.
  const double change = (to.yaw_rad - to.score.azimuth_rad) - (from.yaw_rad - from.score.azimuth_rad);
  return std::abs(std::remainder(change, 2.0 * std::numbers::pi));
}

Figures figures_of(const std::vector<ScoredFrame>& frames, const BootstrapConfig& config) {
  Figures figures;
  // Only places that occur are drawn: an empty one would make a resample smaller than the set.
  std::map<int, int> number_of;
  for (const ScoredFrame& frame : frames) number_of.emplace(frame.place, 0);
  int next = 0;
  for (auto& [place, number] : number_of) number = next++;
  std::vector<ScoredFrame> renumbered = frames;
  for (ScoredFrame& frame : renumbered) {
    frame.place = number_of.at(frame.place);
    figures.open += is_open(frame.score.verdict) ? 1 : 0;
    figures.none += is_none(frame.score.verdict) ? 1 : 0;
    figures.hits += frame.score.verdict == Verdict::kHit ? 1 : 0;
    figures.refused_none += frame.score.verdict == Verdict::kRefusedNone ? 1 : 0;
  }
  figures.frames = static_cast<int>(frames.size());
  figures.places = next;
  const Bootstrap bootstrap(next, config);
  for (int i = 0; i < kFigureCount; ++i) {
    const Statistic statistic = statistic_of(static_cast<Figure>(i), renumbered);
    Estimate& estimate = figures.estimates[static_cast<std::size_t>(i)];
    estimate.value = statistic({});
    if (!std::isnan(estimate.value)) estimate.interval = bootstrap.interval_of(statistic);
  }
  if (const auto claims = claims_of(renumbered); !claims.empty()) figures.reliability = reliability_of(claims, {});
  return figures;
}

}  // namespace adit::eval
