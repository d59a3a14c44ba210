// How far a figure may be trusted: frames of one place are alike, so it is places that are drawn again, not frames.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace adit::eval {

/// One observation. A mean has count 1; a ratio of sums (found of those to be found) has a count of its own.
struct Sample {
  double value = 0.0;
  double count = 1.0;
  int place = 0;  ///< 0 to places - 1
};

/// One answer with its confidence.
struct Claim {
  double confidence = 0.0;  ///< 0 to 1
  bool right = false;
  int place = 0;
};

/// How often each place counts, by number. Empty: once each.
using PlaceWeights = std::span<const int>;

/// Sum of values over sum of counts. NaN when nothing counts; so are the next two.
[[nodiscard]] double mean_of(const std::vector<Sample>& samples, PlaceWeights weights);
/// The value at which half of the weight is reached; between two when it is reached exactly.
/// @param samples  in rising order of value.
[[nodiscard]] double median_of(const std::vector<Sample>& samples, PlaceWeights weights);

/// One bar of the reliability diagram.
struct ReliabilityBin {
  double count = 0.0;
  double confidence = 0.0;  ///< mean
  double right = 0.0;       ///< share
};
inline constexpr int kReliabilityBins = 10;
/// Confidence in ten equal steps; 1 belongs to the last.
[[nodiscard]] std::vector<ReliabilityBin> reliability_of(const std::vector<Claim>& claims, PlaceWeights weights);
/// Expected calibration error: the mean of |right - confidence| over the bins, each by its count.
[[nodiscard]] double calibration_error_of(const std::vector<Claim>& claims, PlaceWeights weights);

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

struct BootstrapConfig {
  int resamples = 2000;
  std::uint64_t seed = 1;
  double coverage = 0.95;
};

/// The same draws of places for every figure and method, so that figures can be compared.
class Bootstrap {
 public:
  /// @param places  how many there are. @throws std::invalid_argument for resamples < 1 or coverage outside (0, 1).
  Bootstrap(int places, const BootstrapConfig& config);

  /// Percentiles of a figure over the draws in which it exists. Nothing for fewer than two places, or when it exists
  /// in fewer than half of the draws.
  [[nodiscard]] std::optional<Interval> interval_of(const std::function<double(PlaceWeights)>& figure) const;

 private:
  int places_;
  int resamples_;
  double coverage_;
  std::vector<int> weights_;  ///< draw after draw, how often each place came
};

/// A generator that gives the same numbers everywhere (splitmix64, Steele et al. 2014).
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) noexcept : state_(seed) {}
  [[nodiscard]] std::uint64_t next() noexcept;
  /// In [0, 1).
  [[nodiscard]] double share() noexcept;

 private:
  std::uint64_t state_;
};

}  // namespace adit::eval
