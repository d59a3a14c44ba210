#include "cusp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace adit {
namespace {

/// Patches along the longer side of the frame: 3.75 deg of a common lens.
constexpr int kPatchesMax = 20;
/// With fewer patches six quadratics and a cusp explain anything.
constexpr int kPatchesMin = 24;
constexpr std::size_t kQuadratics = 6;
/// A passage 5 m wide is this far to the side of its axis 50 m ahead: the cusp is no sharper.
constexpr double kTip_rad = 3.0 * std::numbers::pi / 180.0;
/// Shares of the shading below this are texture.
constexpr float kShareFloor = 0.02F;
/// Walls have less, passages more (way_odds.cpp): says nothing.
constexpr double kShareUnknown = 0.2;
/// Of the frame's shading, squared: below this there is none.
constexpr double kNoShading = 1e-9;

double dot(const float* a, const float* b, std::size_t count) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  return sum;
}

void take(double part, const float* of, float* from, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) from[i] -= static_cast<float>(part) * of[i];
}

void make_unit(float* values, std::size_t count) noexcept {
  const auto length = static_cast<float>(std::sqrt(dot(values, values, count)));
  for (std::size_t i = 0; i < count; ++i) values[i] /= length;
}

/// Squared sine of the angle between two bearings.
double sine_squared(const Bearing& a, const Bearing& b) noexcept {
  const double cosine = std::sin(a.elevation_rad) * std::sin(b.elevation_rad) +
                        std::cos(a.elevation_rad) * std::cos(b.elevation_rad) * std::cos(a.azimuth_rad - b.azimuth_rad);
  return std::max(0.0, 1.0 - cosine * cosine);
}

}  // namespace

CuspFit::CuspFit(const CellGrid& grid, const Camera& camera, int block, double horizon_spread_deg)
    : stride_((std::max(grid.width(), grid.height()) / block + kPatchesMax - 1) / kPatchesMax),
      blocks_(grid.width() / block),
      patch_(stride_ * block),
      width_(grid.width() / patch_),
      height_(grid.height() / patch_),
      most_(kShareUnknown),
      row_(static_cast<std::size_t>(grid.width()), std::int16_t{256}) {
  if (width_ * height_ < kPatchesMin || width_ < 3 || height_ < 3) return;
  const auto patches = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  shading_.resize(patches);
  share_.resize(patches);
  make_quadratics();
  std::vector<Bearing> bearings;
  const double spread_rad = horizon_spread_deg * std::numbers::pi / 180.0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      bearings.push_back(camera.bearing_of({grid.u_px((u + 0.5) * patch_ - 0.5), grid.v_px((v + 0.5) * patch_ - 0.5)}));
      const double away = bearings.back().elevation_rad / spread_rad;
      prior_.push_back(static_cast<float>(std::exp(-0.5 * away * away)));
    }
  }
  draw_cusps(bearings);
  of_u_ = places(grid.width(), patch_, width_);
  of_v_ = places(grid.height(), patch_, height_);
  weight_.resize(static_cast<std::size_t>(height_) * of_u_.size());
}

std::vector<CuspFit::Between> CuspFit::places(int cells, int patch, int patches) {
  std::vector<Between> out;
  for (int cell = 0; cell < cells; ++cell) {
    const float at = (static_cast<float>(cell) + 0.5F) / static_cast<float>(patch) - 0.5F;
    const int first = std::clamp(static_cast<int>(at), 0, patches - 2);
    out.push_back({first, std::clamp(at - static_cast<float>(first), 0.0F, 1.0F)});
  }
  return out;
}

void CuspFit::make_quadratics() {
  const std::size_t count = shading_.size();
  quadratics_.resize(kQuadratics * count);
  std::size_t at = 0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u, ++at) {
      const auto x = static_cast<float>((u + 0.5) / width_ * 2.0 - 1.0);
      const auto y = static_cast<float>((v + 0.5) / height_ * 2.0 - 1.0);
      const std::array<float, kQuadratics> terms{1.0F, x, y, x * x, x * y, y * y};
      for (std::size_t k = 0; k < kQuadratics; ++k) quadratics_[k * count + at] = terms[k];
    }
  }
  for (std::size_t k = 0; k < kQuadratics; ++k) {
    float* const quadratic = quadratics_.data() + k * count;
    for (int pass = 0; pass < 2; ++pass) {  // a second time for what rounding left
      for (std::size_t j = 0; j < k; ++j) {
        const float* const before = quadratics_.data() + j * count;
        take(dot(before, quadratic, count), before, quadratic, count);
      }
    }
    make_unit(quadratic, count);
  }
}

void CuspFit::draw_cusps(const std::vector<Bearing>& bearings) {
  const std::size_t count = bearings.size();
  cusps_.resize(count * count);
  std::vector<float> cusp(count);
  for (std::size_t direction = 0; direction < count; ++direction) {
    for (std::size_t i = 0; i < count; ++i) {
      const double beside = sine_squared(bearings[direction], bearings[i]) + kTip_rad * kTip_rad;
      cusp[i] = static_cast<float>(0.5 * std::log(beside));
    }
    take_quadratic(cusp.data());
    make_unit(cusp.data(), count);
    for (std::size_t i = 0; i < count; ++i) cusps_[i * count + direction] = cusp[i];
  }
}

void CuspFit::take_quadratic(float* values) const noexcept {
  const std::size_t count = shading_.size();
  for (std::size_t k = 0; k < kQuadratics; ++k) {
    const float* const quadratic = quadratics_.data() + k * count;
    take(dot(quadratic, values, count), quadratic, values, count);
  }
}

void CuspFit::average(const std::vector<double>& log_light) noexcept {
  std::size_t at = 0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u, ++at) {
      double sum = 0.0;
      for (int dv = 0; dv < stride_; ++dv) {
        const double* const row = log_light.data() + (v * stride_ + dv) * blocks_ + u * stride_;
        for (int du = 0; du < stride_; ++du) sum += row[du];
      }
      shading_[at] = static_cast<float>(sum / (stride_ * stride_));
    }
  }
}

void CuspFit::rate_directions() noexcept {
  const std::size_t count = shading_.size();
  std::fill(share_.begin(), share_.end(), 0.0F);
  for (std::size_t i = 0; i < count; ++i) {  // directions in the inner loop: no sum depends on the one before
    const float shading = shading_[i];
    const float* __restrict const cusp = cusps_.data() + i * count;
    float* __restrict const along = share_.data();
    for (std::size_t direction = 0; direction < count; ++direction) along[direction] += shading * cusp[direction];
  }
  const auto all = static_cast<float>(dot(shading_.data(), shading_.data(), count) + kNoShading);
  float most = 0.0F;
  for (std::size_t direction = 0; direction < count; ++direction) {
    const float along = std::max(0.0F, share_[direction]);  // brightest at its tip, it is no passage
    share_[direction] = along * along / all;
    most = std::max(most, prior_[direction] * share_[direction]);
  }
  most_ = static_cast<double>(most);
}

void CuspFit::judge(const std::vector<double>& log_light) noexcept {
  if (shading_.empty()) return;
  average(log_light);
  take_quadratic(shading_.data());
  rate_directions();
  const float most = static_cast<float>(most_) + kShareFloor;
  for (float& share : share_) share = 256.0F * std::min(1.0F, std::sqrt(std::sqrt((share + kShareFloor) / most)));
  float* to = weight_.data();
  for (int v = 0; v < height_; ++v) {
    const float* const patches = share_.data() + v * width_;
    for (const Between& at : of_u_) {
      const float* const left = patches + at.first;
      *to++ = left[0] + at.part * (left[1] - left[0]);
    }
  }
}

double CuspFit::share_at(double u, double v) noexcept {
  if (shading_.empty()) return kShareUnknown;
  const double weight =
      weights_of_row(static_cast<int>(std::lround(v)))[static_cast<std::size_t>(std::lround(u))] / 256.0;
  const double floor = static_cast<double>(kShareFloor);
  return std::max(0.0, weight * weight * weight * weight * (most_ + floor) - floor);
}

const std::vector<std::int16_t>& CuspFit::weights_of_row(int v) noexcept {
  if (shading_.empty()) return row_;
  const Between& at = of_v_[static_cast<std::size_t>(v)];
  const std::size_t width = row_.size();
  const float* __restrict const above = weight_.data() + static_cast<std::size_t>(at.first) * width;
  const float* __restrict const below = above + width;
  std::int16_t* __restrict const to = row_.data();
  for (std::size_t u = 0; u < width; ++u) to[u] = static_cast<std::int16_t>(above[u] + at.part * (below[u] - above[u]));
  return row_;
}

}  // namespace adit
