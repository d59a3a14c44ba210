#include <algorithm>
#include <cmath>
#include <numbers>

#include "layout.hpp"

namespace adit::sim {
namespace {

constexpr double kAxisStep_m = 0.5;

AxisPoint point_of(const AxisHead& head) {
  return {head.place.cast<float>(), static_cast<float>(head.width_m), static_cast<float>(head.height_m)};
}

/// The head after `along` metres of an arc that turns by turn_rad over its whole length.
AxisHead moved(const AxisHead& head, double along_m, double length_m, double turn_rad) {
  AxisHead next = head;
  const double turned = turn_rad * along_m / length_m;
  // The chord of an arc points along the mean of its headings.
  const double chord = std::abs(turned) > 1e-9 ? along_m * std::sin(0.5 * turned) / (0.5 * turned) : along_m;
  next.place.x() += chord * std::cos(head.yaw_rad + 0.5 * turned);
  next.place.y() += chord * std::sin(head.yaw_rad + 0.5 * turned);
  next.yaw_rad = head.yaw_rad + turned;
  return next;
}

}  // namespace

void append_move(const Move& move, AxisHead& head, std::vector<AxisPoint>& axis) {
  const double turn_rad = move.turn_deg * std::numbers::pi / 180.0;
  const double length_m = turn_rad != 0.0 ? std::abs(turn_rad) * move.radius_m : move.straight_m;
  const double width_m = move.width_m > 0.0 ? move.width_m : head.width_m;
  const double height_m = move.height_m > 0.0 ? move.height_m : head.height_m;
  if (axis.empty()) axis.push_back(point_of(head));
  const int steps = std::max(1, static_cast<int>(std::lround(length_m / kAxisStep_m)));
  AxisHead next = head;
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    next = moved(head, share * length_m, length_m, turn_rad);
    next.place.z() = head.place.z() + share * move.rise_m;
    next.width_m = std::lerp(head.width_m, width_m, share);
    next.height_m = std::lerp(head.height_m, height_m, share);
    axis.push_back(point_of(next));
  }
  head = next;
}

}  // namespace adit::sim
