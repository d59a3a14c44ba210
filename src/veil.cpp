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
/// Rock that adds this share to the veil is plainly seen.
constexpr double kRockSeen = 0.08;
/// In thick dust what is seen says little; the passage rarely leaves the axis by more than this from one frame to the
/// next: a bend of 10 m radius, 3.5 m ahead.
constexpr double kAxisSpread_rad = 20.0 * std::numbers::pi / 180.0;

/// The share of the blocks that may be darker than they should be: pipes and props near the lens stand before most of
/// the veil.
constexpr double kDarkest = 0.01;

/// Of the mean over a cell, grey levels: 2 in a pixel, over the eight pixels that are read of a cell.
constexpr double kCellNoise_levels = 0.7;
/// What the lobe's six terms leave of a veil without rock, as a share of it (lobe.hpp).
constexpr double kLobeMisfit = 0.015;
/// Parts of the share of rock that a logarithm is kept for, and the largest share that counts, 8: rock within arm's
/// reach.
constexpr int kShareParts = 1024;
constexpr int kShareMax = 8 * kShareParts;

}  // namespace

VeilFit::VeilFit(const CellGrid& grid, const Camera& camera, const FinderConfig& config)
    : block_(std::min({kBlock, grid.width(), grid.height()})),
      width_(grid.width() / block_),
      height_(grid.height() / block_) {
  for (std::size_t part = 0; part < log_light_.size(); ++part) {
    const double level = static_cast<double>(part) / kLevelParts + 1.0;
    log_light_[part] = config.light_gamma * std::log(level / 256.0);
    noise_[part] = static_cast<float>(std::hypot(kLobeMisfit, config.light_gamma * kCellNoise_levels / level));
  }
  const double spread_rad = config.horizon_spread_deg * std::numbers::pi / 180.0;
  const double aspect = static_cast<double>(height_) / width_;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const Pixel middle{grid.u_px((u + 0.5) * block_ - 0.5), grid.v_px((v + 0.5) * block_ - 0.5)};
      const double x = (u + 0.5) / width_ * 2.0 - 1.0, y = ((v + 0.5) / height_ * 2.0 - 1.0) * aspect;
      terms_.push_back(lobe_terms(camera, x, y, middle));
      if (u % 2 == 0 && v % 2 == 0) fit_terms_.push_back(terms_.back());  // the lobe has six parameters
      const Bearing at = camera.bearing_of(middle);
      const double a = at.azimuth_rad / kAxisSpread_rad, e = at.elevation_rad / spread_rad;
      weight_.push_back(std::exp(-0.5 * (a * a + e * e)));
    }
  }
  for (int part = 0; part <= kShareMax; ++part) {
    log_share_[static_cast<std::size_t>(part)] =
        static_cast<std::int16_t>(std::lround(kStop * std::log2((part + 0.5) / kShareParts)));
  }
  log_.resize(terms_.size());
  fit_log_.resize(fit_terms_.size());
  rock_.resize(terms_.size());
  order_.resize(terms_.size());
}

void VeilFit::gather(const CellPlane& levels) noexcept {
  std::size_t fitted = 0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      int sum = 0;
      for (int dv = 0; dv < block_; ++dv) {
        const std::int16_t* row = levels.row(v * block_ + dv) + u * block_;
        for (int du = 0; du < block_; ++du) sum += row[du];
      }
      const double log_light = log_light_[static_cast<std::size_t>(sum / (block_ * block_))];
      log_[static_cast<std::size_t>(v * width_ + u)] = log_light;
      if (u % 2 == 0 && v % 2 == 0) fit_log_[fitted++] = log_light;
    }
  }
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
  const LobeTerms c = lobe_ = fit_lobe(fit_terms_, fit_log_, kBelow);
  std::size_t brightest = 0;
  double most = -1e9;
  for (std::size_t at = 0; at < terms_.size(); ++at) {
    const double lobe = lobe_at(c, terms_[at]);
    if (lobe > most) {
      most = lobe;
      brightest = at;
    }
    const double above = log_[at] - lobe;
    order_[at] = above;
    rock_[at] = above > 0.0 ? std::exp(std::min(above, 12.0)) - 1.0 : 0.0;
  }
  const auto lowest = order_.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(order_.size()) * kDarkest);
  std::nth_element(order_.begin(), lowest, order_.end());
  out.undercut = std::min(1.0, std::exp(*lowest));
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

void VeilFit::take_off(const CellPlane& levels, LobeOnCells& cells, CellPlane& rock) const noexcept {
  const std::vector<float>& lobe = cells.draw(lobe_, static_cast<double>(height_) / width_);
  for (std::size_t i = 0; i < lobe.size(); ++i) {
    const auto part = static_cast<std::size_t>(levels.values[i]);
    const float over = std::exp(static_cast<float>(log_light_[part]) - lobe[i]) - 1.0F;
    const float share = kShareParts * (std::max(over, 0.0F) + noise_[part]);
    rock.values[i] = log_share_[static_cast<std::size_t>(std::min(share, static_cast<float>(kShareMax)))];
  }
}

}  // namespace adit
