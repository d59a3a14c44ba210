#include "lit_plan.hpp"

#include <algorithm>
#include <cmath>

#include "adit/camera.hpp"

namespace adit::test {
namespace {

PlanPoint operator+(PlanPoint a, PlanPoint b) { return {a.x_m + b.x_m, a.y_m + b.y_m}; }
PlanPoint operator-(PlanPoint a, PlanPoint b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
PlanPoint operator*(double s, PlanPoint a) { return {s * a.x_m, s * a.y_m}; }
double dot(PlanPoint a, PlanPoint b) { return a.x_m * b.x_m + a.y_m * b.y_m; }
PlanPoint unit(PlanPoint a) { return 1.0 / std::sqrt(dot(a, a)) * a; }
PlanPoint left_of(PlanPoint a) { return {-a.y_m, a.x_m}; }

/// Way along a ray to a wall, and the cosine at which it is met; no hit: 1e9.
struct Met {
  double range_m = 1e9;
  double cosine = 1.0;
};

Met meet(const std::vector<LitPlan::Wall>& walls, PlanPoint from, PlanPoint way) {
  Met met;
  for (const LitPlan::Wall& wall : walls) {
    const PlanPoint side = wall.to - wall.from, to = wall.from - from;
    const PlanPoint normal = unit(left_of(side));
    const double towards = dot(way, normal);
    if (std::abs(towards) < 1e-9) continue;
    const double range = dot(to, normal) / towards;
    const double along = dot(from + range * way - wall.from, side) / dot(side, side);
    if (range > 1e-6 && range < met.range_m && along >= -1e-9 && along <= 1.0 + 1e-9) met = {range, std::abs(towards)};
  }
  return met;
}

}  // namespace

void LitPlan::add_passage(const std::vector<PlanPoint>& line, double width_m, bool closed_at_end,
                          bool closed_at_begin) {
  std::vector<PlanPoint> left, right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const PlanPoint before = unit(line[std::max<std::size_t>(i, 1)] - line[std::max<std::size_t>(i, 1) - 1]);
    const PlanPoint after = i + 1 < line.size() ? unit(line[i + 1] - line[i]) : before;
    const PlanPoint middle = unit(before + after);
    const PlanPoint aside = 0.5 * width_m / dot(middle, after) * left_of(middle);
    left.push_back(line[i] + aside);
    right.push_back(line[i] - aside);
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    walls.push_back({left[i], left[i + 1]});
    walls.push_back({right[i], right[i + 1]});
  }
  if (closed_at_begin) walls.push_back({left.front(), right.front()});
  if (closed_at_end) walls.push_back({left.back(), right.back()});
}

LitPlan LitPlan::mirrored() const {
  LitPlan other = *this;
  for (Wall& wall : other.walls) {
    wall.from.y_m = -wall.from.y_m;
    wall.to.y_m = -wall.to.y_m;
  }
  return other;
}

Frame LitPlan::seen_from(const PlanPose& pose, unsigned seed, int width, int height) const {
  const Camera camera(pinhole(width, height, 75.0));
  const ColumnRangeConfig expected;
  // Roots of the light, as grey levels are.
  const auto root = [&](double light) { return std::pow(light, 1.0 / expected.display_gamma); };
  std::vector<double> roots(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int u = 0; u < width; ++u) {
    const double azimuth = camera.bearing_of({static_cast<double>(u), 0.5 * height}).azimuth_rad;
    const double yaw = pose.yaw_rad + yaw_of_azimuth(azimuth);
    const Met wall = meet(walls, {pose.x_m, pose.y_m}, {std::cos(yaw), std::sin(yaw)});
    for (int v = 0; v < height; ++v) {
      const double rise = (0.5 * (height - 1) - v) / camera.model().focal_length_y_px * std::cos(azimuth);
      const double flat_m = rise < 0.0 ? eye_m / -rise : rise > 0.0 ? (roof_m - eye_m) / rise : 1e9;
      const double level_m = std::min(wall.range_m, flat_m), level = 1.0 / std::sqrt(1.0 + rise * rise);
      const double range = level_m / level;
      const double cosine = wall.range_m < flat_m ? wall.cosine * level : std::abs(rise) * level;
      const double dust = extinction_1_m > 0.0 ? std::exp(-2.0 * extinction_1_m * range) : 1.0;
      const double lit = range > 200.0 ? 0.0 : cosine / (range * range) * dust;
      roots[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)] =
          root((reach_light * lit + veil) * std::pow(std::cos(azimuth) * level, expected.fall_off_exponent));
    }
  }
  double exposure = 1.0;
  for (int i = 0; i < 8; ++i) {  // as a camera would: the mean goes to 80 levels
    double sum = 0.0;
    for (const double r : roots) sum += std::min(r * exposure, 1.0);
    exposure *= 80.0 / std::max(255.0 * sum / static_cast<double>(roots.size()), 1.0);
  }
  Frame frame(width, height, PixelFormat::kGrey8);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < roots.size(); ++i)
    frame.bytes[i] = static_cast<std::uint8_t>(std::clamp(
        255.0 * std::min(roots[i] * exposure, 1.0) + (seed == 0 ? 0.0 : between(random, -2, 2)) + 0.5, 0.0, 255.0));
  return frame;
}

double LitPlan::pseudo_range_m(const PlanPose& pose, double azimuth_rad) const {
  const double yaw = pose.yaw_rad + yaw_of_azimuth(azimuth_rad);
  const Met met = meet(walls, {pose.x_m, pose.y_m}, {std::cos(yaw), std::sin(yaw)});
  return met.range_m / std::sqrt(met.cosine);
}

double LitPlan::clearance_m(const PlanPose& pose) const {
  double nearest = 1e9;
  const PlanPoint here{pose.x_m, pose.y_m};
  for (const Wall& wall : walls) {
    const PlanPoint side = wall.to - wall.from;
    const double along = std::clamp(dot(here - wall.from, side) / dot(side, side), 0.0, 1.0);
    const PlanPoint off = here - (wall.from + along * side);
    nearest = std::min(nearest, std::sqrt(dot(off, off)));
  }
  return nearest;
}

void PlanFlight::step() {
  constexpr double kStep_s = 0.05;
  const Frame frame = plan->seen_from(pose, 1 + static_cast<unsigned>(std::lround(time_s / kStep_s)));
  command = navigator.update(frame.view(), time_s, {yaw_rate_rad_s, speed_m_s});
  const double wanted_m_s = command.heading.state == HeadingState::kHold ? 0.0 : command.speed_scale;
  for (int i = 0; i < 10; ++i) {
    const double dt = 0.1 * kStep_s;
    speed_m_s += dt / 0.4 * (wanted_m_s - speed_m_s);
    yaw_rate_rad_s += dt / 0.2 * (command.heading.yaw_rate_rad_s - yaw_rate_rad_s);
    pose.yaw_rad += dt * yaw_rate_rad_s;
    turned_rad += dt * yaw_rate_rad_s;
    pose.x_m += dt * speed_m_s * std::cos(pose.yaw_rad);
    pose.y_m += dt * speed_m_s * std::sin(pose.yaw_rad);
  }
  time_s += kStep_s;
  clearance_min_m = std::min(clearance_min_m, plan->clearance_m(pose));
}

}  // namespace adit::test
