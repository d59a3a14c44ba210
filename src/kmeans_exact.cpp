// The optimal partition of points on a line into intervals.
//
// best[k][i] is the least cost of the points i.. in k clusters: the minimum over where the first of the k ends. That
// end never falls as i rises and never rises as k rises, so a row is found by halving it, the middle first, in about n
// log n looks. The points are taken from the bright end, so that the way back starts at the dark end, where ties are
// broken.
#include <algorithm>

#include "levels_in_use.hpp"

namespace adit {
namespace {

constexpr int kPointsMax = 256;
// Two costs that differ by less than this share of the whole are equal. It is above what rounding makes of sums over
// 256 points, and below what parting one pixel of 8192 x 8192 from its neighbouring level gains.
constexpr double kTie = 1e-13;

class IntervalPartition {
 public:
  explicit IntervalPartition(const LevelsInUse& levels) noexcept : count_(levels.count) {
    const auto points = static_cast<std::size_t>(count_);
    double weight = 0.0;
    double moment = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
      weight += levels.weight[i];
      moment += levels.weight[i] * (levels.value[i] - levels.value[0]);
    }
    // Values are taken from their mean, so that an offset common to all of them cannot eat the digits.
    const double mean = levels.value[0] + moment / weight;
    double spread = 0.0;
    weight_[0] = moment_[0] = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
      const double x = levels.value[i] - mean;
      weight_[i + 1] = weight_[i] + levels.weight[i];
      moment_[i + 1] = moment_[i] + levels.weight[i] * x;
      spread += levels.weight[i] * x * x;
    }
    tie_ = kTie * spread;
  }

  /// @param clusters  1 to the number of points.
  [[nodiscard]] ClusterEnds ends_of(int clusters) noexcept {
    for (int i = 0; i < count_; ++i) {
      best_[1][i] = cost(i, count_);
      end_[i] = count_;
    }
    // Row k is asked for from the points that leave at least one for each cluster before and behind.
    for (int k = 2; k < clusters; ++k) fill(k, clusters - k, count_ - k, 0, count_);
    if (clusters > 1) fill(clusters, 0, 0, 0, count_);
    ClusterEnds ends{};
    int first = 0;
    for (int k = clusters; k > 1; --k) {
      first = earliest_end(k, first);
      ends[static_cast<std::size_t>(clusters - k)] = first;
    }
    ends[static_cast<std::size_t>(clusters - 1)] = count_;
    return ends;
  }

 private:
  /// What the points first..end-1 as one cluster add to the cost. The sum of w x^2 is the same for all partitions and
  /// is left out.
  [[nodiscard]] double cost(int first, int end) const noexcept {
    const double weight = weight_[end] - weight_[first];
    const double moment = moment_[end] - moment_[first];
    return -(moment * moment) / weight;
  }

  /// Row k for the points low..high, where the first cluster is known to end in end_low..end_high.
  void fill(int k, int low, int high, int end_low, int end_high) noexcept {
    if (low > high) return;
    const int i = low + (high - low) / 2;
    const int from = std::max(end_low, i + 1);
    const int to = std::max(from, std::min({end_high, end_[i], count_ - (k - 1)}));
    const double* rest = best_[k - 1];
    double least = cost(i, from) + rest[from];
    int least_end = from;
    for (int end = from + 1; end <= to; ++end) {
      const double total = cost(i, end) + rest[end];
      least_end = total < least ? end : least_end;
      least = std::min(least, total);
    }
    best_[k][i] = least;
    end_[i] = least_end;
    fill(k, low, i - 1, end_low, least_end);
    fill(k, i + 1, high, least_end, end_high);
  }

  /// Where the first of k clusters from point `first` ends: the earliest end that is as good as the best.
  [[nodiscard]] int earliest_end(int k, int first) const noexcept {
    const double* rest = best_[k - 1];
    int end = first + 1;
    while (cost(first, end) + rest[end] > best_[k][first] + tie_) ++end;
    return end;
  }

  int count_;
  double tie_ = 0.0;
  std::array<double, kPointsMax + 1> weight_;  // of the points before
  std::array<double, kPointsMax + 1> moment_;  // sum of weight * value of the points before
  double best_[kClusterCountMax + 1][kPointsMax];
  int end_[kPointsMax];  // of the row filled last
};

}  // namespace

Clusters cluster_exact(const std::array<double, 256>& value, const Histogram& histogram, int cluster_count) noexcept {
  const LevelsInUse levels = levels_in_use(value, histogram);
  const int count = std::min({cluster_count, kClusterCountMax, levels.count});
  if (count < 1) return {};
  return clusters_from(levels, IntervalPartition(levels).ends_of(count), count);
}

}  // namespace adit
