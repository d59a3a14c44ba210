#include "veil.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit {
namespace {

/// A block is 4 x 4 cells, 16 px of 640: the veil is far smoother than that.
constexpr int kBlock = 4;
/// The share of the blocks that may lie below the envelope: noise puts some there.
constexpr double kBelow = 0.05;
constexpr int kRounds = 8;
/// Residuals, natural logarithms, below which the weight of a block grows no more: one grey level in twenty.
constexpr double kResidualMin = 0.05;
/// Rock that adds this share to the veil is plainly seen.
constexpr double kRockSeen = 0.15;
/// In thick dust what is seen says little; the passage rarely leaves the axis by more than this from one frame to the
/// next: a bend of 10 m radius, 3.5 m ahead.
constexpr double kAxisSpread_rad = 20.0 * std::numbers::pi / 180.0;

/// Solves the normal equations of the first `count` terms listed in `on`; a pivot that vanishes gives 0.
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

/// The lobe's logarithm where its terms are `t`; t[0] is 1.
double lobe_at(const std::array<double, 5>& c, const std::array<double, 5>& t) noexcept {
  return c[0] + c[1] * t[1] + c[2] * t[2] + c[3] * t[3] + c[4] * t[4];
}

}  // namespace

VeilFit::VeilFit(const CellGrid& grid, const Camera& camera, const FinderConfig& config)
    : block_(std::min({kBlock, grid.width(), grid.height()})),
      width_(grid.width() / block_),
      height_(grid.height() / block_) {
  for (std::size_t part = 0; part < log_light_.size(); ++part) {
    log_light_[part] = config.light_gamma * std::log((static_cast<double>(part) / kLevelParts + 1.0) / 256.0);
  }
  const double spread_rad = config.horizon_spread_deg * std::numbers::pi / 180.0;
  const double aspect = static_cast<double>(height_) / width_;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const double x = (u + 0.5) / width_ * 2.0 - 1.0, y = ((v + 0.5) / height_ * 2.0 - 1.0) * aspect;
      terms_.push_back({1.0, x, y, x * x, y * y});
      const Bearing at = camera.bearing_of({grid.u_px((u + 0.5) * block_ - 0.5), grid.v_px((v + 0.5) * block_ - 0.5)});
      const double a = at.azimuth_rad / kAxisSpread_rad, e = at.elevation_rad / spread_rad;
      weight_.push_back(std::exp(-0.5 * (a * a + e * e)));
    }
  }
  log_.resize(terms_.size());
  rock_.resize(terms_.size());
  order_.resize(terms_.size());
}

void VeilFit::gather(const CellPlane& levels) noexcept {
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      int sum = 0;
      for (int dv = 0; dv < block_; ++dv) {
        const std::int16_t* row = levels.row(v * block_ + dv) + u * block_;
        for (int du = 0; du < block_; ++du) sum += row[du];
      }
      log_[static_cast<std::size_t>(v * width_ + u)] = log_light_[static_cast<std::size_t>(sum / (block_ * block_))];
    }
  }
}

/// Quantile regression by reweighted least squares. A lamp's beam has no valley: curvatures above zero are set to zero.
VeilFit::Coefficients VeilFit::fit() noexcept {
  Coefficients c{};
  for (int round = 0; round < kRounds; ++round) {
    std::array<std::array<double, 5>, 5> normal{};
    std::array<double, 5> right{};
    // Every other block of every other row: the lobe has five parameters.
    for (int v = 0; v < height_; v += 2) {
      for (int u = 0; u < width_; u += 2) {
        const auto at = static_cast<std::size_t>(v * width_ + u);
        const auto& t = terms_[at];
        double weight = 1.0;
        if (round > 0) {
          const double rest = log_[at] - lobe_at(c, t);
          weight = (rest > 0.0 ? kBelow : 1.0 - kBelow) / std::max(std::abs(rest), kResidualMin);
        }
        for (std::size_t i = 0; i < 5; ++i) {
          const double wt = weight * t[i];
          for (std::size_t j = i; j < 5; ++j) normal[i][j] += wt * t[j];
          right[i] += wt * log_[at];
        }
      }
    }
    for (std::size_t i = 0; i < 5; ++i) {
      normal[i][i] += 1e-6;
      for (std::size_t j = 0; j < i; ++j) normal[i][j] = normal[j][i];
    }
    c = solved(normal, right);
    for (int again = 0; again < 2 && (c[3] > 0.0 || c[4] > 0.0); ++again) {
      for (std::size_t i = 3; i < 5; ++i) {
        if (c[i] <= 0.0) continue;
        for (std::size_t j = 0; j < 5; ++j) normal[i][j] = normal[j][i] = 0.0;
        right[i] = 0.0;
      }
      c = solved(normal, right);
    }
  }
  return c;
}

void VeilFit::place(VeilSight& out) noexcept {
  double air = 0.0, all = 0.0, u1 = 0.0, v1 = 0.0, u2 = 0.0, v2 = 0.0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const auto at = static_cast<std::size_t>(v * width_ + u);
      const double w = weight_[at] * std::exp(-rock_[at] / kRockSeen);
      all += weight_[at];
      air += w;
      u1 += w * u;
      v1 += w * v;
      u2 += w * u * u;
      v2 += w * v * v;
    }
  }
  if (!(air > 0.0)) return;
  u1 /= air;
  v1 /= air;
  out.open_share = air / all;
  out.half_width = block_ * std::sqrt(3.0 * std::max(0.0, u2 / air - u1 * u1));
  out.half_height = block_ * std::sqrt(3.0 * std::max(0.0, v2 / air - v1 * v1));
  double sum = 0.0;
  int count = 0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      if ((u - u1) * (u - u1) + (v - v1) * (v - v1) > 2.5 * 2.5) continue;
      sum += rock_[static_cast<std::size_t>(v * width_ + u)];
      ++count;
    }
  }
  out.rock_at_place = count > 0 ? sum / count : 0.0;
  out.u = (u1 + 0.5) * block_ - 0.5;
  out.v = (v1 + 0.5) * block_ - 0.5;
}

VeilSight VeilFit::judge(const CellPlane& levels) noexcept {
  VeilSight out;
  gather(levels);
  const Coefficients c = fit();
  for (std::size_t at = 0; at < terms_.size(); ++at) {
    const auto& t = terms_[at];
    const double above = log_[at] - lobe_at(c, t);
    rock_[at] = above > 0.0 ? std::exp(std::min(above, 12.0)) - 1.0 : 0.0;
  }
  order_ = rock_;
  const auto middle = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() / 2);
  std::nth_element(order_.begin(), middle, order_.end());
  out.fraction = 1.0 / (1.0 + *middle);
  const auto high = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() * 9 / 10);
  std::nth_element(order_.begin(), high, order_.end());
  out.rock_high = *high;
  const double aspect = static_cast<double>(height_) / width_;
  const bool concave = c[3] < 0.0 && c[4] < 0.0;
  out.lobe_in_frame = concave && std::abs(c[1] / (2.0 * c[3])) < 1.0 && std::abs(c[2] / (2.0 * c[4])) < aspect;
  place(out);
  return out;
}

}  // namespace adit
