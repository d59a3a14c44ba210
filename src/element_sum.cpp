#include "element_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace adit {
namespace {

using Chord = ElementSum::Chord;
using Pair = ElementSum::Pair;
using Chords = std::vector<Chord>;

/// The chord of both places where `a` and `b` have one.
Chord overlap(const Chord& a, const Chord& b, int du) {
  return {a.v, std::max(a.left, b.left - du), std::min(a.right, b.right - du)};
}

/// Places p for which p and p + pair are both in `whole`; empty where a row between others would have none.
Chords part_left_by(const Chords& whole, Pair pair, Chords& part) {
  part.clear();
  for (std::size_t i = 0; i + static_cast<std::size_t>(pair.dv) < whole.size(); ++i) {
    const Chord both = overlap(whole[i], whole[i + static_cast<std::size_t>(pair.dv)], pair.du);
    if (both.left <= both.right)
      part.push_back(both);
    else if (!part.empty() || i == 0)
      return {};
  }
  return part;
}

/// Is part + {0, pair} again the whole?
bool makes_up(const Chords& part, Pair pair, const Chords& whole) {
  if (part.empty() || part.front().v != whole.front().v) return false;
  if (part.size() + static_cast<std::size_t>(pair.dv) != whole.size()) return false;
  const auto rows = static_cast<int>(part.size());
  for (int i = 0; i < static_cast<int>(whole.size()); ++i) {
    const Chord& wanted = whole[static_cast<std::size_t>(i)];
    const bool has_first = i < rows, has_second = i >= pair.dv;
    Chord first = wanted, second = wanted;
    if (has_first) first = part[static_cast<std::size_t>(i)];
    if (has_second) {
      second = part[static_cast<std::size_t>(i - pair.dv)];
      second.left += pair.du;
      second.right += pair.du;
    }
    if (!has_first && !has_second) return false;
    if (!has_first) first = second;
    if (!has_second) second = first;
    if (std::max(first.left, second.left) > std::min(first.right, second.right) + 1) return false;  // a gap
    if (std::min(first.left, second.left) != wanted.left || std::max(first.right, second.right) != wanted.right) {
      return false;
    }
  }
  return true;
}

/// Steps along the outline are at most this long, px: twice the square root of the side is never met by a disc's.
int longest_step(const StructuringElement& element) {
  const int side = std::max(element.width(), element.height());
  return element.is_rectangle() ? side : 4 + 2 * static_cast<int>(std::sqrt(static_cast<double>(side)));
}

/// Candidates, the longest first: they leave least to do.
std::vector<Pair> candidates(const StructuringElement& element) {
  std::vector<Pair> all;
  const int longest = longest_step(element);
  for (int dv = 0; dv <= std::min(longest, element.height() - 1); ++dv) {
    const int du_max = dv > 0 && element.is_rectangle() ? 0 : std::min(longest, element.width() - 1);
    for (int du = dv > 0 ? -du_max : 1; du <= du_max; ++du) all.push_back({du, dv});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](Pair a, Pair b) { return std::abs(a.du) + a.dv > std::abs(b.du) + b.dv; });
  return all;
}

}  // namespace

// A part that has no such step will not get one by giving up another: each candidate is asked until it is refused, and
// never again.
ElementSum sum_of(const StructuringElement& element) {
  ElementSum sum;
  const int reach_v = element.height() / 2;
  for (int v = 0; v < element.height(); ++v) {
    sum.core.push_back({v - reach_v, -element.half_chord(v), element.half_chord(v)});
  }
  Chords part;
  for (const Pair pair : candidates(element)) {
    while (makes_up(part_left_by(sum.core, pair, part), pair, sum.core)) {
      sum.core = part;
      sum.pairs.push_back(pair);
    }
  }
  std::stable_sort(sum.pairs.begin(), sum.pairs.end(), [](Pair a, Pair b) { return std::abs(a.du) > std::abs(b.du); });
  return sum;
}

}  // namespace adit
