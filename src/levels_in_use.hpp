// The grey levels that have pixels, as points on a line. Internal to the clustering.
#pragma once

#include <array>
#include <cstdint>

#include "adit/kmeans.hpp"

namespace adit {

/// Points of different value, rising. Levels of equal value (the floor of the transmission) are one point, and so can
/// never part.
struct LevelsInUse {
  int count = 0;
  std::array<double, 256> value;
  std::array<double, 256> weight;  ///< pixels; whole numbers, exact
  std::array<int, 256> last_level;
};

inline LevelsInUse levels_in_use(const std::array<double, 256>& value, const Histogram& histogram) noexcept {
  LevelsInUse levels;
  for (std::size_t level = 0; level < histogram.size(); ++level) {
    if (histogram[level] == 0) continue;
    const auto at = static_cast<std::size_t>(levels.count);
    const bool same = at > 0 && !(value[level] > levels.value[at - 1]);
    if (same) {
      levels.weight[at - 1] += histogram[level];
      levels.last_level[at - 1] = static_cast<int>(level);
    } else {
      levels.value[at] = value[level];
      levels.weight[at] = histogram[level];
      levels.last_level[at] = static_cast<int>(level);
      ++levels.count;
    }
  }
  return levels;
}

/// Where each cluster ends: one past its last point.
using ClusterEnds = std::array<int, kClusterCountMax>;

/// Weights, centres and cost of the clusters that end where `ends` says.
inline Clusters clusters_from(const LevelsInUse& levels, const ClusterEnds& ends, int count) noexcept {
  Clusters out;
  out.count = count;
  std::size_t first = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c) {
    const auto end = static_cast<std::size_t>(ends[c]);
    double weight = 0.0;
    double moment = 0.0;  // about the cluster's first value: nothing is lost to a large offset
    for (std::size_t i = first; i < end; ++i) {
      weight += levels.weight[i];
      moment += levels.weight[i] * (levels.value[i] - levels.value[first]);
    }
    out.centre[c] = levels.value[first] + moment / weight;
    out.weight[c] = static_cast<std::uint32_t>(weight);
    out.last_level[c] = levels.last_level[end - 1];
    for (std::size_t i = first; i < end; ++i) {
      const double off = levels.value[i] - out.centre[c];
      out.cost += levels.weight[i] * off * off;
    }
    first = end;
  }
  return out;
}

}  // namespace adit
