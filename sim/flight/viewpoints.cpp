#include "adit/sim/viewpoints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "field_check.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kTriesMax = 200;
constexpr int kWalkSteps = 40;
constexpr double kFloorReach_m = 20.0;
constexpr double kSeeFloorFrom_m = 0.5;  // over the axis, where no stone is in the way
constexpr std::uint64_t kStream = 6;     // of Random; a flight's own streams are 0 to 5

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }
double either_side(Random& random, double most) { return between(random, -most, most); }

double length_of(const Passage& passage) {
  double length = 0.0;
  for (std::size_t i = 1; i < passage.axis.size(); ++i)
    length += static_cast<double>((passage.axis[i].place - passage.axis[i - 1].place).norm());
  return length;
}

}  // namespace

std::optional<std::string> fault_of(const ViewpointConfig& config) {
  if (auto fault = first_fault(config)) return fault;
  if (config.above_floor_max_m < config.above_floor_min_m)
    return "above_floor_max_m: " + shown(config.above_floor_max_m) + " is below above_floor_min_m, " +
           shown(config.above_floor_min_m) + " m";
  return std::nullopt;
}

ViewpointSource::ViewpointSource(const ViewpointConfig& config, const World& world, const RayScene& scene,
                                 std::uint64_t seed)
    : config_(config), world_(&world), scene_(&scene), seed_(seed) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  double sum = 0.0;
  for (const Passage& passage : world.passages) passage_ends_m_.push_back(sum += length_of(passage));
}

ViewpointSource::Stand ViewpointSource::on_axis(Random& random) const {
  const double at_m = random.uniform() * passage_ends_m_.back();
  const auto found = std::upper_bound(passage_ends_m_.begin(), passage_ends_m_.end(), at_m);
  const auto index = static_cast<std::size_t>(std::min(found, passage_ends_m_.end() - 1) - passage_ends_m_.begin());
  double rest_m = at_m - (index == 0 ? 0.0 : passage_ends_m_[index - 1]);
  const auto& axis = world_->passages[index].axis;
  std::size_t i = 1;
  double step_m = 0.0;
  for (; i + 1 < axis.size(); ++i, rest_m -= step_m) {
    step_m = static_cast<double>((axis[i].place - axis[i - 1].place).norm());
    if (rest_m < step_m) break;
  }
  const Vector3d from = axis[i - 1].place.cast<double>(), to = axis[i].place.cast<double>();
  const double length_m = std::max((to - from).norm(), 1e-6);
  const Vector3d along = (to - from) / length_m;
  // Either way: a passage looks different from its other end.
  const bool turned = random.uniform() < 0.5;
  const double yaw_rad = std::atan2(along.y(), along.x()) + (turned ? std::numbers::pi : 0.0);
  const double aside_m = either_side(random, 0.5 * static_cast<double>(axis[i].width_m) * config_.aside_max_fraction);
  return {from + std::min(rest_m, length_m) * along + aside_m * Vector3d(-along.y(), along.x(), 0.0), yaw_rad};
}

/// From free place to free place: a direction with room is drawn, and a part of the way is gone.
ViewpointSource::Stand ViewpointSource::walked(Random& random) const {
  Vector3d place = world_->start.place.cast<double>();
  double yaw_rad = static_cast<double>(world_->start.yaw_rad);
  const int steps = static_cast<int>(random.uniform() * kWalkSteps);
  for (int s = 0; s < steps; ++s) {
    const double turn_rad = yaw_rad + either_side(random, 80.0 * kDegree);
    const double share = random.uniform();
    const Vector3d eye = place + Vector3d(0, 0, config_.above_floor_min_m + kSeeFloorFrom_m);
    const Vector3d way(std::cos(turn_rad), std::sin(turn_rad), 0.0);
    const auto rock = scene_->closest_hit(eye.cast<float>(), way.cast<float>(), 8.0f);
    const double room_m = (rock ? static_cast<double>(rock->range_m) : 8.0) - 2.0 * config_.free_radius_m;
    if (room_m < 1.0) continue;
    const Vector3d next = eye + share * room_m * way;
    const auto floor = scene_->closest_hit(next.cast<float>(), -Vector3f::UnitZ(), static_cast<float>(kFloorReach_m));
    if (!floor) continue;  // out of the mouth, into the open
    place = floor->place.cast<double>();
    yaw_rad = turn_rad;
  }
  return {place, yaw_rad};
}

VehicleState ViewpointSource::draw(std::int64_t frame) const {
  Random random(seed_ * 0x9e3779b97f4a7c15ull + static_cast<std::uint64_t>(frame), kStream);
  for (int attempt = 0; attempt < kTriesMax; ++attempt) {
    const Stand stand = passage_ends_m_.empty() ? walked(random) : on_axis(random);
    VehicleState v;
    v.height_m = between(random, config_.above_floor_min_m, config_.above_floor_max_m);
    v.yaw_rad =
        std::remainder(stand.yaw_rad + either_side(random, config_.view_yaw_max_deg * kDegree), 2.0 * std::numbers::pi);
    v.pitch_rad = either_side(random, config_.view_pitch_max_deg * kDegree);
    v.roll_rad = either_side(random, config_.view_roll_max_deg * kDegree);
    v.yaw_rate_rad_s = either_side(random, config_.view_turn_max_deg_s * kDegree);
    v.velocity =
        between(random, 0.0, config_.view_speed_max_m_s) * Vector3d(std::cos(v.yaw_rad), std::sin(v.yaw_rad), 0.0);
    v.place = stand.floor + Vector3d(0, 0, v.height_m);
    const auto floor =
        scene_->closest_hit(v.place.cast<float>(), -Vector3f::UnitZ(), static_cast<float>(kFloorReach_m));
    if (!floor) continue;
    v.place.z() = static_cast<double>(floor->place.z()) + v.height_m;
    if (!scene_->nearest(v.place.cast<float>(), static_cast<float>(config_.free_radius_m))) return v;
  }
  throw NoFreePlace("no free place for frame " + std::to_string(frame) + " in " + std::to_string(kTriesMax) +
                    " tries; lower above_floor_max_m, aside_max_fraction or free_radius_m");
}

}  // namespace adit::sim
