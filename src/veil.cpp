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
/// From here on a direction's share of air is below 10^-8: in clear air that is most of them, and an exponential saved.
constexpr double kRockHides = 20.0 * kRockSeen;
/// In thick dust what is seen says little; the passage rarely leaves the axis by more than this from one frame to the
/// next: a bend of 10 m radius, 3.5 m ahead.
constexpr double kAxisSpread_rad = 20.0 * std::numbers::pi / 180.0;

/// A way on through dust may lie anywhere in a common lens' field: a hint, for frames that show nothing.
constexpr double kWaySpread_rad = 40.0 * std::numbers::pi / 180.0;
/// Blocks to either side that rock is averaged over, 7 degrees of a common lens: chips and stains are smaller, and no
/// passage that a vehicle fits into is, as far as dust lets see.
constexpr int kSmoothReach = 3;
/// Rock that counts as none: a twentieth of what the frame shows of it, and what is lost in the fit of the lobe.
constexpr double kAirShare = 0.05, kAirFloor = 0.003;
/// Blocks; one standard deviation of the surroundings from which the middle is taken the second time: 17 degrees.
constexpr double kHeapReach = 8.0;

/// The share of the blocks that may be darker than they should be: pipes and props near the lens stand before most of
/// the veil.
constexpr double kDarkest = 0.01;

/// Shares of the frame below which its dark end and from which on its bright end lies.
constexpr double kDark = 0.02, kBright = 0.9;

/// Of the mean over a cell, grey levels: 2 in a pixel, over the eight pixels that are read of a cell.
constexpr double kCellNoise_levels = 0.7;
/// What the lobe's six terms leave of a veil without rock, as a share of it (lobe.hpp).
constexpr double kLobeMisfit = 0.015;
/// Parts of the share of rock that a logarithm is kept for, and the largest share that counts, 8: rock within arm's
/// reach.
constexpr int kShareParts = 1024;
constexpr int kShareMax = 8 * kShareParts;

/// Mean over a square, at the border over what of it is in the frame as if the border went on.
void mean_of_box(const std::vector<double>& from, std::vector<double>& between, std::vector<double>& to, int width,
                 int height, int reach) noexcept {
  const double share = 1.0 / (2 * reach + 1);
  const auto run = [&](const std::vector<double>& source, std::vector<double>& sink, int length, int step, int base) {
    for (int i = 0; i < length; ++i) {
      double sum = 0.0;
      for (int k = i - reach; k <= i + reach; ++k) {
        sum += source[static_cast<std::size_t>(base + std::clamp(k, 0, length - 1) * step)];
      }
      sink[static_cast<std::size_t>(base + i * step)] = sum * share;
    }
  };
  for (int v = 0; v < height; ++v) run(from, between, width, 1, v * width);
  for (int u = 0; u < width; ++u) run(between, to, height, width, u);
}

struct Middle {
  double u = 0.0, v = 0.0, u_variance = 0.0, v_variance = 0.0;  ///< blocks
};

/// Of weights, all of them or those about another middle.
Middle middle_of(const std::vector<double>& weights, int width, const Middle* about) noexcept {
  double all = 0.0, u1 = 0.0, v1 = 0.0, u2 = 0.0, v2 = 0.0;
  for (std::size_t at = 0; at < weights.size(); ++at) {
    const int u = static_cast<int>(at) % width, v = static_cast<int>(at) / width;
    double w = weights[at];
    if (about != nullptr) {
      const double du = (u - about->u) / kHeapReach, dv = (v - about->v) / kHeapReach;
      w *= std::exp(-0.5 * (du * du + dv * dv));
    }
    all += w;
    u1 += w * u;
    v1 += w * v;
    u2 += w * u * u;
    v2 += w * v * v;
  }
  if (!(all > 0.0)) return about != nullptr ? *about : Middle{};
  u1 /= all;
  v1 /= all;
  return {u1, v1, std::max(0.0, u2 / all - u1 * u1), std::max(0.0, v2 / all - v1 * v1)};
}

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
      const double aside = at.azimuth_rad / kWaySpread_rad;
      prior_.push_back(std::exp(-0.5 * (aside * aside + e * e)));
    }
  }
  for (int part = 0; part <= kShareMax; ++part) {
    log_share_[static_cast<std::size_t>(part)] =
        static_cast<std::int16_t>(std::lround(kStop * std::log2((part + 0.5) / kShareParts)));
  }
  columns_.resize(static_cast<std::size_t>(grid.width()));
  log_.resize(terms_.size());
  fit_log_.resize(fit_terms_.size());
  rock_.resize(terms_.size());
  order_.resize(terms_.size());
  smooth_.resize(terms_.size());
}

double VeilFit::log_light_below(double share) const noexcept {
  const int most = static_cast<int>(share * static_cast<double>(log_.size()));
  std::size_t part = 0;
  for (int below = counts_[0]; below <= most && part + 1 < counts_.size(); below += counts_[part]) ++part;
  return log_light_[part];
}

void VeilFit::gather(const CellPlane& levels, VeilSight& out) noexcept {
  counts_.fill(0);
  std::size_t fitted = 0;
  for (int v = 0; v < height_; ++v) {
    std::int16_t* __restrict const columns = columns_.data();  // at most four rows: 4 * 4080 fits
    std::copy_n(levels.row(v * block_), levels.width, columns);
    for (int dv = 1; dv < block_; ++dv) {
      const std::int16_t* __restrict const row = levels.row(v * block_ + dv);
      for (int u = 0; u < levels.width; ++u) columns[u] = static_cast<std::int16_t>(columns[u] + row[u]);
    }
    for (int u = 0; u < width_; ++u) {
      int sum = 0;
      for (int du = 0; du < block_; ++du) sum += columns[u * block_ + du];
      const auto part = static_cast<std::size_t>(sum / (block_ * block_));
      ++counts_[part];
      const double log_light = log_light_[part];
      log_[static_cast<std::size_t>(v * width_ + u)] = log_light;
      if (u % 2 == 0 && v % 2 == 0) fit_log_[fitted++] = log_light;
    }
  }
  const double median = log_light_below(0.5);
  out.below_stops = (median - log_light_below(kDark)) / std::numbers::ln2;
  out.above_stops = (log_light_below(kBright) - median) / std::numbers::ln2;
}

double VeilFit::open_share() const noexcept {
  double air = 0.0, all = 0.0;
  for (std::size_t at = 0; at < rock_.size(); ++at) {
    all += weight_[at];
    if (rock_[at] < kRockHides) air += weight_[at] * std::exp(-rock_[at] / kRockSeen);
  }
  return air / all;
}

AirPlace VeilFit::air_place(const VeilSight& veil) noexcept {
  // Twice a box: the texture of rock and the noise of the veil go, and a place counts as air when its surroundings do.
  mean_of_box(rock_, order_, smooth_, width_, height_, kSmoothReach);
  mean_of_box(smooth_, order_, smooth_, width_, height_, kSmoothReach);
  const double seen = kAirShare * veil.rock_high + kAirFloor;
  for (std::size_t at = 0; at < smooth_.size(); ++at) order_[at] = prior_[at] * std::exp(-smooth_[at] / seen);
  const Middle all = middle_of(order_, width_, nullptr);
  const Middle near =
      middle_of(order_, width_, &all);  // once towards the nearest heap, so that of two ways one is meant
  AirPlace out;
  out.u = (near.u + 0.5) * block_ - 0.5;
  out.v = (near.v + 0.5) * block_ - 0.5;
  out.half_width = block_ * std::sqrt(3.0 * near.u_variance);
  out.half_height = block_ * std::sqrt(3.0 * near.v_variance);
  return out;
}

VeilSight VeilFit::judge(const CellPlane& levels) noexcept {
  VeilSight out;
  gather(levels, out);
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
  out.open_share = open_share();
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
