// The published iteration (paper, eq. 6 and 7) on points on a line. Sorted centres own intervals, so assigning is
// finding where the midpoints between neighbouring centres lie.
#include <algorithm>
#include <cmath>

#include "levels_in_use.hpp"

namespace adit {
namespace {

/// splitmix64 (Steele, Lea, Flood, 2014): a few lines, the same numbers on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) noexcept : state_(seed) {}

  std::uint64_t next() noexcept {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Even over 0..bound-1: numbers that would favour the low ones are drawn again.
  std::uint64_t below(std::uint64_t bound) noexcept {
    const std::uint64_t unfair = (0 - bound) % bound;
    std::uint64_t drawn = next();
    while (drawn < unfair) drawn = next();
    return drawn % bound;
  }

 private:
  std::uint64_t state_;
};

using Centres = std::array<double, kClusterCountMax>;

/// Values of pixels drawn at random; a value that was drawn is not drawn again, so no cluster starts empty.
Centres drawn_centres(const LevelsInUse& levels, int count, RandomNumbers& random) noexcept {
  std::array<std::uint64_t, 256> left{};
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(levels.count); ++i) {
    left[i] = static_cast<std::uint64_t>(levels.weight[i]);
    total += left[i];
  }
  Centres centres{};
  for (int c = 0; c < count; ++c) {
    std::uint64_t pixel = random.below(total);
    std::size_t i = 0;
    while (pixel >= left[i]) pixel -= left[i++];
    centres[static_cast<std::size_t>(c)] = levels.value[i];
    total -= left[i];
    left[i] = 0;
  }
  std::sort(centres.begin(), centres.begin() + count);
  return centres;
}

/// Eq. (7): each point to its nearest centre; a point midway goes to the darker one.
ClusterEnds assigned(const LevelsInUse& levels, const Centres& centres, int count) noexcept {
  ClusterEnds ends{};
  int point = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c) {
    const bool last = c + 1 == static_cast<std::size_t>(count);
    const double border = last ? 0.0 : 0.5 * (centres[c] + centres[c + 1]);
    while (point < levels.count && (last || levels.value[static_cast<std::size_t>(point)] <= border)) ++point;
    ends[c] = point;
  }
  return ends;
}

/// A cluster that lost all its points takes one from its neighbour: from the darker side if there is one to spare.
void fill_empty(int points, int count, ClusterEnds& ends) noexcept {
  for (int c = 0; c < count; ++c) {
    const int least = c + 1;  // one point for this cluster and each before it
    ends[static_cast<std::size_t>(c)] = std::max(ends[static_cast<std::size_t>(c)], least);
    if (c > 0) {
      const int after_last = ends[static_cast<std::size_t>(c) - 1] + 1;
      ends[static_cast<std::size_t>(c)] = std::max(ends[static_cast<std::size_t>(c)], after_last);
    }
  }
  for (int c = count - 1; c >= 0; --c) {
    const int most = points - (count - 1 - c);  // one point for each cluster behind
    ends[static_cast<std::size_t>(c)] = std::min(ends[static_cast<std::size_t>(c)], most);
  }
}

Clusters from_one_start(const LevelsInUse& levels, int count, const LloydSettings& settings,
                        RandomNumbers& random) noexcept {
  const double range = levels.value[static_cast<std::size_t>(levels.count - 1)] - levels.value[0];
  Centres centres = drawn_centres(levels, count, random);
  Clusters clusters;
  for (int iteration = 1; iteration <= std::max(settings.iterations_max, 1); ++iteration) {
    ClusterEnds ends = assigned(levels, centres, count);
    fill_empty(levels.count, count, ends);
    clusters = clusters_from(levels, ends, count);
    clusters.iterations = iteration;
    double moved = 0.0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c) {
      moved = std::max(moved, std::abs(clusters.centre[c] - centres[c]));
    }
    centres = clusters.centre;
    if (moved <= settings.tolerance * range) break;
  }
  return clusters;
}

}  // namespace

Clusters cluster_lloyd(const std::array<double, 256>& value, const Histogram& histogram, int cluster_count,
                       const LloydSettings& settings) noexcept {
  const LevelsInUse levels = levels_in_use(value, histogram);
  const int count = std::min({cluster_count, kClusterCountMax, levels.count});
  if (count < 1) return {};
  RandomNumbers random(settings.seed);
  Clusters best = from_one_start(levels, count, settings, random);
  for (int start = 1; start < settings.starts; ++start) {
    const Clusters clusters = from_one_start(levels, count, settings, random);
    if (clusters.cost < best.cost) best = clusters;
  }
  return best;
}

}  // namespace adit
