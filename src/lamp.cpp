#include "adit/lamp.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lobe.hpp"

namespace adit {
namespace {

constexpr auto kCells = static_cast<std::size_t>(kLampColumns) * kLampRows;
/// A cell's brightest moments: what it shows or exceeds in three frames of twenty, when lit rock is near in it.
constexpr double kBrightMoments = 0.85;
/// The pattern is drawn over the brighter half of the cells: those that never hold near rock, such as the far end of a
/// straight drift, lie below it.
constexpr double kBelowPattern = 0.5;
/// How far a cell's value follows one frame, natural logarithms: a stop in about a hundred frames, three to five
/// seconds.
constexpr double kStepFirst = 0.5, kStepLast = 0.01;
/// Mean change of the cells from frame to frame below which the vehicle stands still: under noise of two levels.
constexpr double kStandstill = 0.02;
constexpr int kFramesBetweenFits = 8;

}  // namespace

const char* fault_of(const LampPattern& pattern) noexcept {
  for (const double c : pattern.lobe) {
    if (!std::isfinite(c)) return "lobe: not a number";
  }
  if (pattern.lobe[3] > 0.0 || pattern.lobe[4] > 0.0 || pattern.lobe[5] > 0.0) {
    return "lobe: the fourth to sixth number must be at most 0: a beam has no valley";
  }
  if (!(pattern.frames >= 0.0) || !std::isfinite(pattern.frames)) return "frames: not a number from 0 on";
  return "";
}

struct LampModel::State {
  std::vector<LobeTerms> terms;
  std::vector<double> bright = std::vector<double>(kCells);  ///< each cell's brightest moments over the frame's median
  std::vector<double> last = std::vector<double>(kCells);
  std::vector<double> order = std::vector<double>(kCells);
  LampPattern pattern;
  int until_fit = kFramesBetweenFits;
  bool begun = false;
};

LampModel::LampModel(const Camera& camera) : state_(std::make_unique<State>()) {
  const double width = camera.model().width, height = camera.model().height;
  for (int v = 0; v < kLampRows; ++v) {
    for (int u = 0; u < kLampColumns; ++u) {
      const Pixel at{(u + 0.5) * width / kLampColumns - 0.5, (v + 0.5) * height / kLampRows - 0.5};
      const double x = (u + 0.5) / kLampColumns * 2.0 - 1.0;
      const double y = ((v + 0.5) / kLampRows * 2.0 - 1.0) * height / width;
      state_->terms.push_back(lobe_terms(camera, x, y, at));
    }
  }
}

LampModel::LampModel(const Camera& camera, const LampPattern& known) : LampModel(camera) {
  if (*fault_of(known) != '\0') throw std::invalid_argument(fault_of(known));
  State& s = *state_;
  s.pattern = known;
  for (std::size_t i = 0; i < kCells; ++i) s.bright[i] = lobe_at(known.lobe, s.terms[i]);
  s.begun = known.frames > 0.0;
}

LampModel::~LampModel() = default;
LampModel::LampModel(LampModel&&) noexcept = default;
LampModel& LampModel::operator=(LampModel&&) noexcept = default;

const LampPattern& LampModel::pattern() const noexcept { return state_->pattern; }

bool LampModel::learn(const LampGlimpse& glimpse) noexcept {
  if (!glimpse.usable) return false;
  State& s = *state_;
  // Over the frame's own median: exposure and gain cancel.
  std::copy(glimpse.log_light.begin(), glimpse.log_light.end(), s.order.begin());
  const auto middle = s.order.begin() + kCells / 2;
  std::nth_element(s.order.begin(), middle, s.order.end());
  const double median = *middle;
  double change = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) change += std::abs(glimpse.log_light[i] - median - s.last[i]);
  if (s.begun && change < kStandstill * kCells) return false;
  const double step = std::max(kStepLast, kStepFirst / (1.0 + s.pattern.frames));
  for (std::size_t i = 0; i < kCells; ++i) {
    const double now = glimpse.log_light[i] - median;
    s.last[i] = now;
    if (!s.begun) s.bright[i] = now;
    s.bright[i] += step * (now > s.bright[i] ? kBrightMoments : kBrightMoments - 1.0);
  }
  s.begun = true;
  s.pattern.frames += 1.0;
  if (--s.until_fit > 0) return false;
  s.until_fit = kFramesBetweenFits;
  s.pattern.lobe = fit_lobe(s.terms, s.bright, kBelowPattern);
  return true;
}

}  // namespace adit
