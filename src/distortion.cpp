#include "distortion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit {
namespace {

constexpr double kRadiusMax = 57.3;     // tan(89 deg)
constexpr double kSeenRadiusMax = 1e8;  // keeps squares finite; far outside any lens's circle
constexpr int kRadiusSteps = 4096;      // of the search for the circle's edge
constexpr int kBisections = 200;        // more than a double has bits
constexpr int kNewtonSteps = 50;
constexpr int kHalvings = 30;

bool tangential(const CameraModel& m) noexcept {
  return m.distortion_model != DistortionModel::kEquidistant && (m.distortion[2] != 0.0 || m.distortion[3] != 0.0);
}

/// The radius after the radial part of the model.
double radial(const CameraModel& m, double r) noexcept {
  const auto& k = m.distortion;
  const double r2 = r * r;
  switch (m.distortion_model) {
    case DistortionModel::kNone:
      return r;
    case DistortionModel::kPlumbBob:
      return r * (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4])));
    case DistortionModel::kRationalPolynomial:
      return r * ((1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]))));
    case DistortionModel::kEquidistant:
      return r * (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * (k[2] + r2 * k[3]))));
  }
  return r;
}

double length(NormalisedPoint p) noexcept { return std::hypot(p.sx, p.sy); }
NormalisedPoint scaled(NormalisedPoint p, double by) noexcept { return {p.sx * by, p.sy * by}; }
NormalisedPoint minus(NormalisedPoint a, NormalisedPoint b) noexcept { return {a.sx - b.sx, a.sy - b.sy}; }

/// The radius in [0, radius_max] that the radial part puts at `seen`; it grows there, so halving finds it.
double radial_inverse(const CameraModel& m, double radius_max, double seen) noexcept {
  if (!(seen < radial(m, radius_max))) return radius_max;
  double low = 0.0;
  double high = radius_max;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (radial(m, middle) < seen ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The Newton step at p: the Jacobian by central differences, good for the 1e-9 asked for because steps repeat.
NormalisedPoint newton_step(const CameraModel& m, NormalisedPoint p, NormalisedPoint residual) noexcept {
  const double h = 1e-6 * std::max(1.0, length(p));
  const NormalisedPoint du = scaled(minus(distorted(m, {p.sx + h, p.sy}), distorted(m, {p.sx - h, p.sy})), 0.5 / h);
  const NormalisedPoint dv = scaled(minus(distorted(m, {p.sx, p.sy + h}), distorted(m, {p.sx, p.sy - h})), 0.5 / h);
  const double determinant = du.sx * dv.sy - dv.sx * du.sy;
  if (!(std::abs(determinant) > 1e-12)) return {};
  return {(dv.sy * residual.sx - dv.sx * residual.sy) / determinant,
          (du.sx * residual.sy - du.sy * residual.sx) / determinant};
}

/// Newton's iteration from a start near the answer; a step that does not help is halved, and none leaves the circle.
NormalisedPoint refined(const CameraModel& m, double radius_max, NormalisedPoint start, NormalisedPoint seen) noexcept {
  NormalisedPoint best = start;
  NormalisedPoint residual = minus(distorted(m, best), seen);
  double error = length(residual);
  for (int i = 0; i < kNewtonSteps && error > 0.0; ++i) {
    NormalisedPoint step = newton_step(m, best, residual);
    bool better = false;
    for (int halving = 0; halving < kHalvings && !better; ++halving, step = scaled(step, 0.5)) {
      NormalisedPoint next = minus(best, step);
      const double radius = length(next);
      if (radius > radius_max) next = scaled(next, radius_max / radius);
      const NormalisedPoint next_residual = minus(distorted(m, next), seen);
      const double next_error = length(next_residual);
      better = next_error < error;  // false for NaN
      if (better) {
        best = next;
        residual = next_residual;
        error = next_error;
      }
    }
    if (!better) break;
  }
  return best;
}

}  // namespace

NormalisedPoint distorted(const CameraModel& model, NormalisedPoint point) noexcept {
  const double r = length(point);
  const double scale = r > 0.0 ? radial(model, r) / r : 1.0;
  NormalisedPoint out = scaled(point, scale);
  if (tangential(model)) {
    const double p1 = model.distortion[2];
    const double p2 = model.distortion[3];
    const auto [x, y] = point;
    out.sx += 2.0 * p1 * x * y + p2 * (r * r + 2.0 * x * x);
    out.sy += p1 * (r * r + 2.0 * y * y) + 2.0 * p2 * x * y;
  }
  return out;
}

double growing_radius_max(const CameraModel& model) noexcept {
  const double end = model.distortion_model == DistortionModel::kEquidistant ? std::numbers::pi : kRadiusMax;
  if (model.distortion_model == DistortionModel::kNone) return end;
  // Fine near the axis, where all lenses live, and coarse far out. The first fall ends the circle.
  double last_radius = 0.0;
  double last_seen = 0.0;
  for (int i = 1; i <= kRadiusSteps; ++i) {
    const double share = static_cast<double>(i) / kRadiusSteps;
    const double radius = end * share * share;
    const double seen = radial(model, radius);
    if (!(seen > last_seen)) break;
    last_radius = radius;
    last_seen = seen;
  }
  return last_radius;
}

NormalisedPoint undistorted(const CameraModel& model, double radius_max, NormalisedPoint seen) noexcept {
  seen = {std::clamp(seen.sx, -kSeenRadiusMax, kSeenRadiusMax), std::clamp(seen.sy, -kSeenRadiusMax, kSeenRadiusMax)};
  const double radius = length(seen);
  if (radius == 0.0 && !tangential(model)) return seen;
  const double start = radial_inverse(model, radius_max, radius);
  const NormalisedPoint point = radius > 0.0 ? scaled(seen, start / radius) : seen;
  return tangential(model) ? refined(model, radius_max, point, seen) : point;
}

}  // namespace adit
