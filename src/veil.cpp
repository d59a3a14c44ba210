#include "veil.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cell_filters.hpp"

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
constexpr double kRockSeen = 0.08;
/// In thick dust what is seen says little; the passage rarely leaves the axis by more than this from one frame to the
/// next: a bend of 10 m radius, 3.5 m ahead.
constexpr double kAxisSpread_rad = 20.0 * std::numbers::pi / 180.0;

/// Of the mean over a cell, grey levels: 2 in a pixel, over the eight pixels that are read of a cell.
constexpr double kCellNoise_levels = 0.7;
/// Parts of the share of rock that a logarithm is kept for, and the largest share that counts, 8: rock within arm's
/// reach.
constexpr int kShareParts = 1024;
constexpr int kShareMax = 8 * kShareParts;

/// Logarithm of 1 / cos^2 of the angle to the axis: a flood's light and a lens's vignetting fall with powers of the
/// cosine.
double flood_term(const Camera& camera, Pixel at) noexcept {
  const NormalisedPoint p = camera.normalised_of(at);
  return std::log1p(p.sx * p.sx + p.sy * p.sy);
}

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
double lobe_at(const LobeTerms& c, const LobeTerms& t) noexcept {
  return c[0] + c[1] * t[1] + c[2] * t[2] + c[3] * t[3] + c[4] * t[4] + c[5] * t[5];
}

}  // namespace

VeilFit::VeilFit(const CellGrid& grid, const Camera& camera, const FinderConfig& config)
    : block_(std::min({kBlock, grid.width(), grid.height()})),
      width_(grid.width() / block_),
      height_(grid.height() / block_) {
  for (std::size_t part = 0; part < log_light_.size(); ++part) {
    const double level = static_cast<double>(part) / kLevelParts + 1.0;
    log_light_[part] = config.light_gamma * std::log(level / 256.0);
    noise_[part] = static_cast<float>(config.light_gamma * kCellNoise_levels / level);
  }
  const double spread_rad = config.horizon_spread_deg * std::numbers::pi / 180.0;
  const double aspect = static_cast<double>(height_) / width_;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const double x = (u + 0.5) / width_ * 2.0 - 1.0, y = ((v + 0.5) / height_ * 2.0 - 1.0) * aspect;
      const Pixel middle{grid.u_px((u + 0.5) * block_ - 0.5), grid.v_px((v + 0.5) * block_ - 0.5)};
      terms_.push_back({1.0, x, y, x * x, y * y, flood_term(camera, middle)});
      const Bearing at = camera.bearing_of(middle);
      const double a = at.azimuth_rad / kAxisSpread_rad, e = at.elevation_rad / spread_rad;
      weight_.push_back(std::exp(-0.5 * (a * a + e * e)));
    }
  }
  of_column_.resize(static_cast<std::size_t>(grid.width()));
  for (int v = 0; v < grid.height(); ++v) {
    for (int u = 0; u < grid.width(); ++u) {
      flood_terms_.push_back(static_cast<float>(flood_term(camera, {grid.u_px(u), grid.v_px(v)})));
    }
  }
  for (int part = 0; part <= kShareMax; ++part) {
    log_share_[static_cast<std::size_t>(part)] =
        static_cast<std::int16_t>(std::lround(kStop * std::log2((part + 0.5) / kShareParts)));
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
LobeTerms VeilFit::fit() noexcept {
  LobeTerms c{};
  for (int round = 0; round < kRounds; ++round) {
    std::array<LobeTerms, kLobeTerms> normal{};
    LobeTerms right{};
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
        for (std::size_t i = 0; i < kLobeTerms; ++i) {
          const double wt = weight * t[i];
          for (std::size_t j = i; j < kLobeTerms; ++j) normal[i][j] += wt * t[j];
          right[i] += wt * log_[at];
        }
      }
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
  const LobeTerms c = lobe_ = fit();
  std::size_t brightest = 0;
  double most = -1e9;
  for (std::size_t at = 0; at < terms_.size(); ++at) {
    const double lobe = lobe_at(c, terms_[at]);
    if (lobe > most) {
      most = lobe;
      brightest = at;
    }
    const double above = log_[at] - lobe;
    rock_[at] = above > 0.0 ? std::exp(std::min(above, 12.0)) - 1.0 : 0.0;
  }
  order_ = rock_;
  const auto middle = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() / 2);
  std::nth_element(order_.begin(), middle, order_.end());
  out.fraction = 1.0 / (1.0 + *middle);
  const auto high = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() * 9 / 10);
  std::nth_element(order_.begin(), high, order_.end());
  out.rock_high = *high;
  const int u = static_cast<int>(brightest) % width_, v = static_cast<int>(brightest) / width_;
  out.lobe_in_frame = u > 0 && v > 0 && u + 1 < width_ && v + 1 < height_;
  place(out);
  return out;
}

void VeilFit::take_off(const CellPlane& levels, CellPlane& rock) noexcept {
  const double aspect = static_cast<double>(height_) / width_;
  for (int u = 0; u < levels.width; ++u) {
    const double x = (u + 0.5) / levels.width * 2.0 - 1.0;
    of_column_[static_cast<std::size_t>(u)] = static_cast<float>(lobe_[0] + x * (lobe_[1] + x * lobe_[3]));
  }
  const auto flood = static_cast<float>(lobe_[5]);
  for (int v = 0; v < levels.height; ++v) {
    const double y = ((v + 0.5) / levels.height * 2.0 - 1.0) * aspect;
    const auto of_row = static_cast<float>(y * (lobe_[2] + y * lobe_[4]));
    const float* const term = flood_terms_.data() + static_cast<std::ptrdiff_t>(v) * levels.width;
    const std::int16_t* const level = levels.row(v);
    std::int16_t* const to = rock.row(v);
    for (int u = 0; u < levels.width; ++u) {
      const auto part = static_cast<std::size_t>(level[u]);
      const float lobe = of_column_[static_cast<std::size_t>(u)] + of_row + flood * term[u];
      const float over = std::exp(static_cast<float>(log_light_[part]) - lobe) - 1.0F;
      const float share = kShareParts * (std::max(over, 0.0F) + noise_[part]);
      to[u] = log_share_[static_cast<std::size_t>(std::min(share, static_cast<float>(kShareMax)))];
    }
  }
}

}  // namespace adit
