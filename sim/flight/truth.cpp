#include "adit/sim/truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adit/sim/flight_fields.hpp"
#include "field_check.hpp"
#include "ray_batch.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kCircleRays = 120;
constexpr double kClearanceMax_m = 50.0;
// The grid of directions in which the deepest one is sought.
constexpr double kAzimuthStep_deg = 1.0;
constexpr double kElevationStep_deg = 4.0;
constexpr int kElevationSteps = 11;
constexpr double kIntoBranch_m = 2.0;

double horizontal_distance(const Vector3d& a, const Vector3d& b) { return (a - b).head<2>().norm(); }

/// The mean over `half` neighbours to either side, those beyond the end left out.
std::vector<double> smoothed(const std::vector<double>& values, int count, int half) {
  std::vector<double> means(values.size());
  for (int i = 0; i < count; ++i) {
    double sum = 0.0;
    int taken = 0;
    for (int k = std::max(0, i - half); k <= std::min(count - 1, i + half); ++k, ++taken)
      sum += values[static_cast<std::size_t>(k)];
    means[static_cast<std::size_t>(i)] = sum / taken;
  }
  return means;
}

}  // namespace

std::optional<std::string> fault_of(const TruthConfig& config) { return first_fault(config); }

Bearing bearing_to(const CameraPose& camera_pose, const Vector3d& point) {
  const Vector3d p = camera_pose.inverse(Eigen::Isometry) * point;
  return {std::atan2(p.x(), p.z()), std::atan2(-p.y(), std::hypot(p.x(), p.z()))};
}

std::vector<float> range_image_m(const RayScene& scene, const Camera& camera, const CameraPose& camera_pose,
                                 float range_max_m) {
  std::vector<float> image;
  image.reserve(static_cast<std::size_t>(camera.model().width) * static_cast<std::size_t>(camera.model().height));
  const Vector3f origin = camera_pose.translation().cast<float>();
  std::vector<Vector3f> directions(static_cast<std::size_t>(camera.model().width));
  for (int v = 0; v < camera.model().height; ++v) {
    for (int u = 0; u < camera.model().width; ++u) {
      const NormalisedPoint p = camera.normalised_of({static_cast<double>(u), static_cast<double>(v)});
      directions[static_cast<std::size_t>(u)] =
          (camera_pose.linear() * Vector3d(p.sx, p.sy, 1.0).normalized()).cast<float>();
    }
    const auto row = ranges_from(scene, origin, directions, range_max_m);
    image.insert(image.end(), row.begin(), row.end());
  }
  return image;
}

Surveyor::Surveyor(const TruthConfig& config, const RayScene& scene, const Network& network, double hfov_deg)
    : config_(config), scene_(&scene), network_(&network), hfov_deg_(hfov_deg) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  for (int i = 0; i < kCircleRays; ++i)
    circle_rad_.push_back(static_cast<float>(2.0 * std::numbers::pi * i / kCircleRays));
}

Truth Surveyor::look(const Vector3d& body, const Vector3d& heading, const CameraPose& camera_pose, double height_m,
                     const std::optional<AxisPlace>& start) const {
  Truth truth;
  measure_clearance(body, truth);
  find_deepest(camera_pose, truth);
  if (network_->empty())
    find_gap(body, heading, camera_pose, truth);
  else
    follow_network(body, heading, camera_pose, height_m, start, truth);
  return truth;
}

void Surveyor::measure_clearance(const Vector3d& body, Truth& truth) const {
  const Vector3f origin = body.cast<float>();
  const auto near = scene_->nearest(origin, static_cast<float>(kClearanceMax_m));
  truth.clearance_m = near ? static_cast<double>(near->distance_m) : kClearanceMax_m;
  const auto ranges = scene_->horizontal_ranges_m(origin, 0.0f, circle_rad_, static_cast<float>(kClearanceMax_m));
  truth.side_clearance_m = static_cast<double>(*std::min_element(ranges.begin(), ranges.end()));
}

void Surveyor::follow_network(const Vector3d& body, const Vector3d& heading, const CameraPose& camera_pose,
                              double height_m, const std::optional<AxisPlace>& start, Truth& truth) const {
  const AxisPlace here = network_->nearest(body);
  truth.aside_m = here.aside_m;
  truth.to_goal_m = network_->to_goal_m(here);
  if (start) {
    const double goal_way_m = network_->to_goal_m(*start);
    truth.progress_m = std::isfinite(goal_way_m) ? goal_way_m - truth.to_goal_m : network_->between_m(*start, here);
  }
  const Vector3d up = height_m * Vector3d::UnitZ();
  for (const Ahead& ahead : network_->ahead(here, heading, config_.look_ahead_m)) {
    if (ahead.at_end && (ahead.end == NodeKind::kDeadEnd || horizontal_distance(ahead.place, body) < 0.5)) continue;
    const Bearing bearing = bearing_to(camera_pose, ahead.place + up);
    if (!(std::abs(bearing.azimuth_rad) >= std::abs(truth.passage.azimuth_rad))) truth.passage = bearing;
    truth.branches.push_back(bearing);
  }
  const std::size_t near = truth.branches.size();
  for (const Ahead& ahead : network_->branches(here, heading, config_.branch_range_m, kIntoBranch_m)) {
    const Vector3d eye = ahead.place + up;
    if (ahead.at_end || horizontal_distance(ahead.place, body) <= config_.look_ahead_m) continue;
    if (scene_->occluded(camera_pose.translation().cast<float>(), eye.cast<float>())) continue;
    truth.branches.push_back(bearing_to(camera_pose, eye));
  }
  // A single way on is the stem of the branches that lie beyond it, not one more.
  if (near == 1 && truth.branches.size() > near) truth.branches.erase(truth.branches.begin());
}

/// Without a layout: on a circle of look_ahead_m about the body, the middle of that gap in the rock whose middle is
/// closest to the nose. In a room wider than the circle the ring has no rock; then the nose itself is free.
void Surveyor::find_gap(const Vector3d& body, const Vector3d& heading, const CameraPose& camera_pose,
                        Truth& truth) const {
  const double yaw_rad = std::atan2(heading.y(), heading.x());
  // Seen from the nose, from the far left to the far right: what lies behind is no way on.
  constexpr int kRays = 181;
  std::vector<float> angles(kRays);
  for (int i = 0; i < kRays; ++i) angles[static_cast<std::size_t>(i)] = static_cast<float>((90.0 - i) * kDegree);
  const auto ranges = scene_->horizontal_ranges_m(body.cast<float>(), static_cast<float>(yaw_rad), angles,
                                                  static_cast<float>(config_.look_ahead_m));
  double best_deg = kUnknown;
  for (int i = 0; i < kRays; ++i) {
    if (ranges[static_cast<std::size_t>(i)] < static_cast<float>(config_.look_ahead_m)) continue;
    int last = i;
    while (last + 1 < kRays && ranges[static_cast<std::size_t>(last + 1)] >= static_cast<float>(config_.look_ahead_m))
      ++last;
    const double middle_deg = 90.0 - 0.5 * (i + last);
    const Vector3d place = body + config_.look_ahead_m * Vector3d(std::cos(yaw_rad + middle_deg * kDegree),
                                                                  std::sin(yaw_rad + middle_deg * kDegree), 0.0);
    const Bearing bearing = bearing_to(camera_pose, place);
    truth.branches.push_back(bearing);
    if (!(std::abs(middle_deg) >= std::abs(best_deg))) {
      best_deg = middle_deg;
      truth.passage = bearing;
    }
    i = last;
  }
}

void Surveyor::find_deepest(const CameraPose& camera_pose, Truth& truth) const {
  const int columns = 2 * static_cast<int>(0.5 * hfov_deg_ / kAzimuthStep_deg) + 1;
  const auto azimuth_of = [columns](int i) { return (i - columns / 2) * kAzimuthStep_deg * kDegree; };
  const auto elevation_of = [](int k) { return (k - kElevationSteps / 2) * kElevationStep_deg * kDegree; };
  std::vector<Vector3f> directions;
  directions.reserve(static_cast<std::size_t>(columns * kElevationSteps));
  for (int k = 0; k < kElevationSteps; ++k)
    for (int i = 0; i < columns; ++i) {
      const double a = azimuth_of(i), e = elevation_of(k);
      const Vector3d optical(std::sin(a) * std::cos(e), -std::sin(e), std::cos(a) * std::cos(e));
      directions.push_back((camera_pose.linear() * optical).cast<float>());
    }
  const auto ranges = ranges_from(*scene_, camera_pose.translation().cast<float>(), directions,
                                  static_cast<float>(config_.sight_max_m));
  truth.deepest_range_m = -1.0;
  const int half = static_cast<int>(std::lround(0.5 * config_.sight_smoothing_deg / kAzimuthStep_deg));
  for (int k = 0; k < kElevationSteps; ++k) {
    std::vector<double> row(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i)
      row[static_cast<std::size_t>(i)] = static_cast<double>(ranges[static_cast<std::size_t>(k * columns + i)]);
    const auto means = smoothed(row, columns, half);
    const auto best = std::max_element(means.begin(), means.end());
    // A plateau (range limited, or open air) is answered by its middle, not by its left edge.
    auto last = best;
    while (last + 1 != means.end() && *(last + 1) >= *best) ++last;
    if (*best <= truth.deepest_range_m) continue;
    truth.deepest_range_m = *best;
    const double column = 0.5 * static_cast<double>((best - means.begin()) + (last - means.begin()));
    truth.deepest = {(column - columns / 2) * kAzimuthStep_deg * kDegree, elevation_of(k)};
  }
  truth.opening_in_sight = truth.deepest_range_m >= config_.opening_range_min_m;
}

}  // namespace adit::sim
