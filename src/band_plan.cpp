#include <cstdlib>
#include <limits>

#include "band_pass.hpp"

namespace adit {
namespace {

using From = BandPlan::From;
using Operand = BandPlan::Operand;
using Step = BandPlan::Step;
using Pair = ElementSum::Pair;

/// What is sure to stay in a level-1 cache of 32 KiB, and in a level-2 cache that others use too, bytes.
constexpr double kLevel1Bytes = 21 * 1024;
constexpr double kLevel2Bytes = 400 * 1024;
/// What a line of 64 bytes costs that comes from level 2 and goes back there, cycles.
constexpr double kLevel2Cycles = 8.0;
/// What a window down a column costs for each vector, cycles; other steps one cycle an operand.
constexpr double kWindowCycles = 4.0;
/// Shorter ones are cheaper by steps.
constexpr int kColumnWindowMin = 5;
/// What the call of a step costs, cycles.
constexpr double kCallCycles = 60.0;
int rounded_up(int columns) { return static_cast<int>(AlignedBytes::rounded_up(static_cast<std::size_t>(columns))); }

/// Steps that turn a pixel into `length` pixels in a row: each takes two or three windows of the last length, where it
/// begins to where it ends.
std::vector<std::vector<int>> widenings(int length) {
  std::vector<std::vector<int>> steps;
  for (int columns = 1; columns < length;) {
    const int more = std::min(length - columns, 2 * columns);
    steps.push_back(more > columns ? std::vector<int>{0, (more + 1) / 2, more} : std::vector<int>{0, more});
    columns += more;
  }
  return steps;
}

/// Along one axis, pairs that reach 1, 2, 3, ... without a gap are one window. Takes them out; its length, or 1.
int take_window(std::vector<Pair>& pairs, bool is_vertical) {
  const auto is_along = [is_vertical](Pair pair) { return (is_vertical ? pair.du : pair.dv) == 0; };
  std::vector<int> reaches;
  for (const Pair pair : pairs) {
    if (is_along(pair)) reaches.push_back(pair.du + pair.dv);
  }
  std::sort(reaches.begin(), reaches.end());
  int length = 1;
  for (const int reach : reaches) {
    if (reach > length) return 1;
    length += reach;
  }
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_along), pairs.end());
  return length;
}

void add_row_window(std::vector<Step>& steps, int length) {
  for (const std::vector<int>& places : widenings(length)) {
    Step& step = steps.emplace_back();
    for (const int place : places) step.add({place, 0});
  }
}

void add_column_window(std::vector<Step>& steps, int length) {
  if (length < kColumnWindowMin) {
    for (const std::vector<int>& places : widenings(length)) {
      Step& step = steps.emplace_back();
      for (const int place : places) step.add({0, place});
      step.dv_max = places.back();
    }
    return;
  }
  while (length > 1) {
    Step& step = steps.emplace_back();
    step.window = std::min(length, kernels::kWindowMax);
    step.dv_max = step.window - 1;
    step.add({0, 0});
    length -= step.dv_max;
  }
}

/// Columns that a step reaches to the right.
int reach_of(const Step& step) {
  int reach = 0;
  for (int i = 0; i < step.count; ++i) reach = std::max(reach, step.operands[static_cast<std::size_t>(i)].du);
  return reach;
}

/// Four places of a lozenge at once where a pair has its mirror image, else two.
std::vector<Step> folds_of(std::vector<Pair> pairs) {
  std::vector<Step> folds;
  const int width = take_window(pairs, false), height = take_window(pairs, true);
  add_row_window(folds, width);
  while (!pairs.empty()) {
    const Pair pair = pairs.front();
    pairs.erase(pairs.begin());
    const auto mirrored = std::find_if(pairs.begin(), pairs.end(), [pair](Pair other) {
      return pair.du != 0 && other.du == -pair.du && other.dv == pair.dv;
    });
    const int du = std::abs(pair.du), dv = pair.dv;
    Step& step = folds.emplace_back();
    if (mirrored != pairs.end()) {
      pairs.erase(mirrored);
      for (const BandPlan::Operand place : {BandPlan::Operand{du, 0}, {0, dv}, {2 * du, dv}, {du, 2 * dv}}) {
        step.add(place);
      }
      step.dv_max = 2 * dv;
      step.is_lozenge = true;
    } else {
      step.add({std::max(0, -pair.du), 0});
      step.add({std::max(0, pair.du), dv});
      step.dv_max = dv;
    }
  }
  add_column_window(folds, height);
  return folds;
}

/// Steps that go before all others where the core is a pixel: the first that stay in a row, or else a copy.
std::vector<Step> core_of_pixel(std::vector<Step>& folds) {
  std::vector<Step> steps;
  while (!folds.empty() && folds.front().dv_max == 0) {
    steps.push_back(folds.front());
    folds.erase(folds.begin());
  }
  if (steps.empty()) steps.emplace_back().add({0, 0});
  for (Operand& operand : steps.front().operands) operand.from = From::kSource;
  return steps;
}

/// One chord of the core after the other, the longest first. Pixels are taken in where there is room beside.
std::vector<Step> core_of(const std::vector<ElementSum::Chord>& chords) {
  const int top = chords.front().v;
  int left = std::numeric_limits<int>::max();
  for (const ElementSum::Chord& chord : chords) left = std::min(left, chord.left);
  std::vector<ElementSum::Chord> sorted = chords;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.right - a.left > b.right - b.left; });
  std::vector<Step> steps;
  for (const ElementSum::Chord& chord : sorted) {
    const BandPlan::Operand place{chord.left - left, chord.v - top, From::kSource};
    if (chord.left == chord.right) {
      if (steps.empty() || steps.back().count == kernels::kOperandsMax) {
        const bool is_first = steps.empty();
        steps.emplace_back();
        if (!is_first) steps.back().add({0, 0});
      }
      steps.back().add(place);
      continue;
    }
    const bool is_first = steps.empty();
    bool from_source = true;
    for (const std::vector<int>& places : widenings(chord.right - chord.left + 1)) {
      Step& step = steps.emplace_back();
      step.to = is_first ? From::kMain : From::kWindows;
      for (const int at : places) {
        step.add(from_source ? BandPlan::Operand{place.du + at, place.dv, From::kSource}
                             : BandPlan::Operand{at, 0, step.to});
      }
      from_source = false;
    }
    steps.back().to = From::kMain;
    if (!is_first) steps.back().add({0, 0});
  }
  return steps;
}

}  // namespace

BandPlan::BandPlan(int width, const StructuringElement& element, int strip)
    : plane_width(width),
      element_width(element.width()),
      element_height(element.height()),
      is_rectangle(element.is_rectangle()) {
  const ElementSum sum = sum_of(element);
  core_rows = static_cast<int>(sum.core.size());
  fold_rows = element_height - core_rows;
  for (int v = 0; v < element_height; ++v) reach_u = std::max(reach_u, element.half_chord(v));
  folds = folds_of(sum.pairs);
  const bool is_pixel = core_rows == 1 && sum.core[0].left == sum.core[0].right;
  core = is_pixel ? core_of_pixel(folds) : core_of(sum.core);
  int reach = 0;
  for (const Step& fold : folds) reach += reach_of(fold);
  choose_strip(reach, strip);
  const int widest = rounded_up(strip_columns + 2 * reach_u);
  pitch = widest;
  // A chord is widened step by step: before the last one, all of a row is needed.
  for (Step& step : core) step.width = widest;
  for (Step& fold : folds) fold.width = rounded_up(strip_columns + (reach -= reach_of(fold)));
}

// Cycles on a core with vectors of 64 bytes, roughly; elsewhere all parts are dearer alike.
void BandPlan::choose_strip(int reach, int strip) {
  double least = std::numeric_limits<double>::max();
  const int most = strip > 0 ? 1 : std::max(1, plane_width / 64);
  for (int strips = 1; strips <= most; ++strips) {
    const int columns = strip > 0 ? strip : (plane_width + strips - 1) / strips;
    const int widest = rounded_up(columns + 2 * reach_u);
    double steps = 0.0;
    for (const Step& step : core) steps += step.count * widest;
    int ahead = reach;
    for (const Step& fold : folds) {
      steps += (fold.window > 0 ? kWindowCycles : fold.count) * rounded_up(columns + (ahead -= reach_of(fold)));
    }
    for (int rows : {8, 12, 16}) {
      const double lines = widest / 64.0;
      const double step_bytes = static_cast<double>(rows) * widest;
      const double all_bytes = static_cast<double>(fold_rows + rows) * widest;
      double cost = steps / 64.0 + kCallCycles * static_cast<double>(core.size() + folds.size()) / rows;
      if (step_bytes > kLevel1Bytes) {
        cost += kLevel2Cycles * lines * static_cast<double>(core.size() + folds.size());
      } else if (all_bytes > kLevel1Bytes) {
        cost += kLevel2Cycles * lines * (fold_rows + rows) / rows;
      }
      if (all_bytes > kLevel2Bytes) cost *= 2;
      cost *= strips;
      if (cost >= least) continue;
      least = cost;
      strip_columns = columns;
      band = rows;
      // In level 1 each line counts; beyond it rows are moved up less often.
      room = all_bytes <= kLevel1Bytes ? rows : 4 * rows;
    }
  }
  // A window works in blocks as high as itself: no block for a row or two.
  for (const Step& fold : folds) {
    if (fold.window > 0 && fold.window < band) band -= band % fold.window;
  }
}

bool BandPlan::is_for(int width, const StructuringElement& element) const noexcept {
  return plane_width == width && element_width == element.width() && element_height == element.height() &&
         is_rectangle == element.is_rectangle();
}

// A step may read beyond the last row by its own reach.
std::size_t BandPlan::bytes_needed() const noexcept {
  const int rows = fold_rows + core_rows + room + 2 * band + 2;
  return static_cast<std::size_t>(pitch) * static_cast<std::size_t>(rows) + kAliasPeriod;
}

}  // namespace adit
