#include "adit/eval/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace adit::eval {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

double weight_of(PlaceWeights weights, int place) {
  return weights.empty() ? 1.0 : static_cast<double>(weights[static_cast<std::size_t>(place)]);
}

/// Linear between the two nearest ranks. @param sorted  not empty
double percentile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(rank));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

double mean_of(const std::vector<Sample>& samples, PlaceWeights weights) {
  double sum = 0.0, count = 0.0;
  for (const Sample& sample : samples) {
    const double weight = weight_of(weights, sample.place);
    sum += weight * sample.value;
    count += weight * sample.count;
  }
  return count > 0.0 ? sum / count : kNothing;
}

double median_of(const std::vector<Sample>& samples, PlaceWeights weights) {
  double total = 0.0;
  for (const Sample& sample : samples) total += weight_of(weights, sample.place);
  double reached = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double weight = weight_of(weights, samples[i].place);
    reached += weight;
    if (weight == 0.0 || 2.0 * reached < total) continue;
    if (2.0 * reached > total) return samples[i].value;
    const auto next = std::find_if(samples.begin() + static_cast<std::ptrdiff_t>(i) + 1, samples.end(),
                                   [weights](const Sample& s) { return weight_of(weights, s.place) > 0.0; });
    return next == samples.end() ? samples[i].value : 0.5 * (samples[i].value + next->value);
  }
  return kNothing;
}

std::vector<ReliabilityBin> reliability_of(const std::vector<Claim>& claims, PlaceWeights weights) {
  std::vector<ReliabilityBin> bins(kReliabilityBins);
  for (const Claim& claim : claims) {
    const int bin = std::clamp(static_cast<int>(claim.confidence * kReliabilityBins), 0, kReliabilityBins - 1);
    const double weight = weight_of(weights, claim.place);
    ReliabilityBin& b = bins[static_cast<std::size_t>(bin)];
    b.count += weight;
    b.confidence += weight * claim.confidence;
    b.right += claim.right ? weight : 0.0;
  }
  for (ReliabilityBin& b : bins)
    if (b.count > 0.0) {
      b.confidence /= b.count;
      b.right /= b.count;
    }
  return bins;
}

double calibration_error_of(const std::vector<Claim>& claims, PlaceWeights weights) {
  double sum = 0.0, count = 0.0;
  for (const ReliabilityBin& bin : reliability_of(claims, weights)) {
    sum += bin.count * std::abs(bin.right - bin.confidence);
    count += bin.count;
  }
  return count > 0.0 ? sum / count : kNothing;
}

Bootstrap::Bootstrap(int places, const BootstrapConfig& config)
    : places_(places), resamples_(config.resamples), coverage_(config.coverage) {
  if (config.resamples < 1) throw std::invalid_argument("resamples: at least 1 is needed");
  if (!(config.coverage > 0.0 && config.coverage < 1.0))
    throw std::invalid_argument("coverage: it lies between 0 and 1");
  if (places_ < 2) return;
  RandomNumbers random(config.seed);
  weights_.assign(static_cast<std::size_t>(places_) * static_cast<std::size_t>(resamples_), 0);
  for (int r = 0; r < resamples_; ++r) {
    const std::size_t row = static_cast<std::size_t>(r) * static_cast<std::size_t>(places_);
    for (int i = 0; i < places_; ++i)
      ++weights_[row + static_cast<std::size_t>(random.share() * static_cast<double>(places_))];
  }
}

std::optional<Interval> Bootstrap::interval_of(const std::function<double(PlaceWeights)>& figure) const {
  if (places_ < 2) return std::nullopt;
  std::vector<double> values;
  const auto places = static_cast<std::size_t>(places_);
  for (std::size_t r = 0; r < static_cast<std::size_t>(resamples_); ++r)
    if (const double value = figure(PlaceWeights(weights_.data() + r * places, places)); !std::isnan(value))
      values.push_back(value);
  if (2 * values.size() < static_cast<std::size_t>(resamples_)) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double tail = 0.5 * (1.0 - coverage_);
  return Interval{percentile(values, tail), percentile(values, 1.0 - tail)};
}

std::uint64_t RandomNumbers::next() noexcept {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

double RandomNumbers::share() noexcept { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

}  // namespace adit::eval
