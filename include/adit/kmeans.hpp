// k-means on a grey image (paper, eq. 6 and 7). On one dimension the clusters are intervals, so a weighted
// histogram is all that is needed, and the optimum can be found exactly.
#pragma once

#include <array>
#include <cstdint>

#include "adit/api.hpp"

namespace ADIT_API adit {

/// Pixels per grey level.
using Histogram = std::array<std::uint32_t, 256>;

inline constexpr int kClusterCountMax = 32;

/// The outcome of clustering the 256 grey levels, each with a value and a weight.
struct Clusters {
  int count = 0;                                  ///< min(cluster_count, levels in use); 0 for an empty histogram
  std::array<double, kClusterCountMax> centre{};  ///< weighted mean of the values of each cluster, rising
  std::array<std::uint32_t, kClusterCountMax> weight{};  ///< pixels of each cluster
  std::array<int, kClusterCountMax> last_level{};        ///< largest grey level in use in each cluster, rising
  double cost = 0.0;                                     ///< sum of weight * (value - centre)^2
  int iterations = 0;                                    ///< Lloyd only: iterations of the best start
};

/// How the published iteration runs.
struct LloydSettings {
  std::uint64_t seed = 0;
  int starts = 1;           ///< random starts, the cheapest wins; >= 1
  int iterations_max = 10;  ///< per start; >= 1
  double tolerance = 1.0;   ///< stop when no centre moved further than this, as a fraction of the range of values; >= 0
};

/// The optimal partition, by dynamic programming with a monotone argmin (H. Wang and M. Song, The R Journal 3/2, 2011;
/// A. Grønlund et al., arXiv 1701.07204, 2017). Partitions whose costs differ by less than 1e-13 of the cost of one
/// single cluster are ties; they are broken towards the partition whose darker clusters are smaller. Allocates nothing.
/// @param value   finite, never falling with the level; levels of equal value stay together.
/// @param histogram  its sum fits 32 bits.
/// @param cluster_count  1 to kClusterCountMax.
[[nodiscard]] Clusters cluster_exact(const std::array<double, 256>& value, const Histogram& histogram,
                                     int cluster_count) noexcept;

/// The published iteration (eq. 6 and 7): random centres, assign, average, until nothing moves. Start centres are the
/// values of pixels drawn at random, each value once; a value midway between two centres goes to the darker; a cluster
/// that lost its last value takes one of its neighbour's. The same seed gives the same answer on every machine.
/// Allocates nothing. Parameters as above.
[[nodiscard]] Clusters cluster_lloyd(const std::array<double, 256>& value, const Histogram& histogram,
                                     int cluster_count, const LloydSettings& settings) noexcept;

}  // namespace adit
