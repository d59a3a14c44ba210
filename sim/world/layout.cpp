#include "layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::sim {
namespace {

/// The start: along the first passage's axis (or before its beginning), aside and turned as asked.
StartPose start_of(const Layout& layout, const CourseConfig& config) {
  StartPose start;
  if (layout.passages.empty()) return start;
  const std::vector<AxisPoint>& axis = layout.passages.front().axis;
  double left_m = config.start_along_m;
  std::size_t i = 0;
  double step_m = (axis[1].place - axis[0].place).norm();
  while (left_m > step_m && i + 2 < axis.size()) {
    left_m -= step_m;
    ++i;
    step_m = (axis[i + 1].place - axis[i].place).norm();
  }
  const Eigen::Vector3f way = (axis[i + 1].place - axis[i].place) / static_cast<float>(step_m);
  start.place = axis[i].place + way * static_cast<float>(left_m);
  if (config.start_along_m < 0.0) start.place.z() = axis.front().place.z();
  start.place += static_cast<float>(config.start_offset_m) * Eigen::Vector3f(-way.y(), way.x(), 0.0f).normalized();
  start.yaw_rad = std::atan2(way.y(), way.x()) + static_cast<float>(config.start_yaw_deg * std::numbers::pi / 180.0);
  return start;
}

}  // namespace

Layout lay_out(const CourseConfig& config) {
  Layout layout;
  switch (config.layout) {
    case LayoutKind::kMoves:
      layout = lay_out_moves(config);
      break;
    case LayoutKind::kRandomTunnel:
    case LayoutKind::kRandomNetwork:
      layout = lay_out_random(config);
      break;
    case LayoutKind::kTiles:
      layout = lay_out_tiles(config);
      break;
  }
  layout.start = start_of(layout, config);
  return layout;
}

}  // namespace adit::sim
