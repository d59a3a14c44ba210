#include "lobe.hpp"

#include <algorithm>
#include <cmath>

namespace adit {
namespace {

/// Six rounds move no weight by more than a hundredth; two more for good measure.
constexpr int kRounds = 8;
/// Residuals, natural logarithms, below which a weight grows no more: one grey level in twenty.
constexpr double kResidualMin = 0.05;

/// Two columns of a row; the compiler's own loops over columns become no vector code worth the name.
using Pair = double __attribute__((vector_size(16)));
/// A sample's terms, its value, and a column of nothing: an even number.
constexpr std::size_t kPairs = (kLobeTerms + 2) / 2;
using Columns = std::array<Pair, kPairs>;
using Sums = std::array<Columns, kLobeTerms>;
/// Samples that are weighed before they are summed.
constexpr std::size_t kBatch = 32;

/// Weighted products of terms 2 * Of and 2 * Of + 1 with all from there on and with the value. Two terms at a time:
/// their sums all lie in registers.
template <std::size_t Of>
void add_products(const Columns* samples, const double* weights, std::size_t count, Sums& sums) noexcept {
  Columns one = sums[2 * Of], other = sums[2 * Of + 1];
  for (std::size_t at = 0; at < count; ++at) {
    const Columns& sample = samples[at];
    const Pair by = weights[at] * sample[Of];
    const Pair by_one{by[0], by[0]}, by_other{by[1], by[1]};
    for (std::size_t j = Of; j < kPairs; ++j) {
      one[j] += by_one * sample[j];
      other[j] += by_other * sample[j];
    }
  }
  sums[2 * Of] = one;
  sums[2 * Of + 1] = other;
}

/// The sums of the normal equations of the samples, those nearest the lobe `c` weighing most. Without a lobe, all
/// alike.
Sums normal_sums(const std::vector<LobeTerms>& terms, const std::vector<double>& values, double below,
                 const LobeTerms* c) noexcept {
  const double share_of_side[] = {1.0 - below, below};
  Sums sums{};
  std::array<Columns, kBatch> samples;
  std::array<double, kBatch> weights;
  weights.fill(1.0);
  for (std::size_t from = 0; from < terms.size(); from += kBatch) {
    const std::size_t count = std::min(kBatch, terms.size() - from);
    for (std::size_t i = 0; i < count; ++i) {
      const LobeTerms& t = terms[from + i];
      const double value = values[from + i];
      samples[i] = {Pair{t[0], t[1]}, Pair{t[2], t[3]}, Pair{t[4], t[5]}, Pair{value, 0.0}};
      if (c == nullptr) continue;
      const double rest = value - lobe_at(*c, t);
      // From a table: which side a sample lies on is as good as random, and a branch would be guessed wrongly.
      weights[i] = share_of_side[rest > 0.0 ? 1 : 0] / std::max(std::abs(rest), kResidualMin);
    }
    add_products<0>(samples.data(), weights.data(), count, sums);
    add_products<1>(samples.data(), weights.data(), count, sums);
    add_products<2>(samples.data(), weights.data(), count, sums);
  }
  return sums;
}

/// Solves normal equations; a pivot that vanishes gives 0.
template <std::size_t N>
std::array<double, N> solved(std::array<std::array<double, N>, N> a, std::array<double, N> b) noexcept {
  for (std::size_t i = 0; i < N; ++i) {
    const double pivot = a[i][i];
    if (!(std::abs(pivot) > 1e-12)) {
      a[i].fill(0.0);
      b[i] = 0.0;
      continue;
    }
    for (std::size_t j = i; j < N; ++j) a[i][j] /= pivot;
    b[i] /= pivot;
    for (std::size_t k = 0; k < N; ++k) {
      if (k == i) continue;
      const double factor = a[k][i];
      for (std::size_t j = i; j < N; ++j) a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  }
  return b;
}

}  // namespace

double flood_term(const Camera& camera, Pixel at) noexcept {
  const NormalisedPoint p = camera.normalised_of(at);
  return std::log1p(p.sx * p.sx + p.sy * p.sy);
}

LobeTerms lobe_terms(const Camera& camera, double x, double y, Pixel at) noexcept {
  return {1.0, x, y, x * x, y * y, flood_term(camera, at)};
}

LobeTerms fit_lobe(const std::vector<LobeTerms>& terms, const std::vector<double>& values, double below) noexcept {
  LobeTerms c{};
  for (int round = 0; round < kRounds; ++round) {
    const Sums sums = normal_sums(terms, values, below, round > 0 ? &c : nullptr);
    std::array<LobeTerms, kLobeTerms> normal;
    LobeTerms right;
    for (std::size_t i = 0; i < kLobeTerms; ++i) {
      for (std::size_t j = 0; j < kLobeTerms; ++j) normal[i][j] = sums[i][j / 2][j % 2];
      right[i] = sums[i][kPairs - 1][0];
    }
    for (std::size_t i = 0; i < kLobeTerms; ++i) {
      normal[i][i] += 1e-6;
      for (std::size_t j = 0; j < i; ++j) normal[i][j] = normal[j][i];
    }
    c = solved(normal, right);
    for (int again = 0; again < 3 && (c[3] > 0.0 || c[4] > 0.0 || c[5] > 0.0); ++again) {
      for (std::size_t i = 3; i < kLobeTerms; ++i) {
        if (c[i] <= 0.0) continue;
        for (std::size_t j = 0; j < kLobeTerms; ++j) normal[i][j] = normal[j][i] = 0.0;
        right[i] = 0.0;
      }
      c = solved(normal, right);
    }
  }
  return c;
}

LobeOnCells::LobeOnCells(const CellGrid& grid, const Camera& camera)
    : width_(grid.width()), of_column_(static_cast<std::size_t>(grid.width())) {
  for (int v = 0; v < grid.height(); ++v) {
    for (int u = 0; u < width_; ++u) {
      flood_terms_.push_back(static_cast<float>(flood_term(camera, {grid.u_px(u), grid.v_px(v)})));
    }
  }
  drawn_.resize(flood_terms_.size());
}

const std::vector<float>& LobeOnCells::draw(const LobeTerms& lobe, double aspect) noexcept {
  for (int u = 0; u < width_; ++u) {
    const double x = (u + 0.5) / width_ * 2.0 - 1.0;
    of_column_[static_cast<std::size_t>(u)] = static_cast<float>(lobe[0] + x * (lobe[1] + x * lobe[3]));
  }
  const auto flood = static_cast<float>(lobe[5]);
  const int height = static_cast<int>(drawn_.size()) / width_;
  for (int v = 0; v < height; ++v) {
    const double y = ((v + 0.5) / height * 2.0 - 1.0) * aspect;
    const auto of_row = static_cast<float>(y * (lobe[2] + y * lobe[4]));
    const float* const term = flood_terms_.data() + static_cast<std::ptrdiff_t>(v) * width_;
    float* const to = drawn_.data() + static_cast<std::ptrdiff_t>(v) * width_;
    for (int u = 0; u < width_; ++u) to[u] = of_column_[static_cast<std::size_t>(u)] + of_row + flood * term[u];
  }
  return drawn_;
}

}  // namespace adit
