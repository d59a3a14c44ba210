#include "adit/sim/occupancy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace adit::sim {
namespace {

// Log-odds of 0.7 and 0.4, clamped to those of 0.12 and 0.97.
constexpr float kMet = 0.85f, kPassed = -0.40f, kLowest = -2.0f, kHighest = 3.5f;

int floor_div(int value, int by) { return value >= 0 ? value / by : -((by - 1 - value) / by); }

}  // namespace

OccupancyGrid::OccupancyGrid(double cell_m) : cell_m_(cell_m) {
  if (!(cell_m >= 0.01 && cell_m <= 10.0)) throw std::invalid_argument("the cell of a map is 0.01 to 10 m");
}

OccupancyGrid::Cell& OccupancyGrid::cell(int x, int y, Nearby& nearby) {
  const int tile_x = floor_div(x, kTileSide), tile_y = floor_div(y, kTileSide);
  if (nearby.tile == nullptr || tile_x != nearby.x || tile_y != nearby.y)
    nearby = {&tiles_[{tile_y, tile_x}], tile_x, tile_y};
  return (*nearby.tile)[static_cast<std::size_t>((y - tile_y * kTileSide) * kTileSide + x - tile_x * kTileSide)];
}

void OccupancyGrid::mark(int x, int y, bool met, Nearby& nearby) {
  Cell& c = cell(x, y, nearby);
  if (c.scan == scans_) {
    if (!met || c.met) return;
    c.log_odds += kMet - kPassed;  // it was taken for passed earlier in this scan
  } else {
    c.log_odds += met ? kMet : kPassed;
  }
  c.scan = scans_;
  c.met = met;
  c.log_odds = std::clamp(c.log_odds, kLowest, kHighest);
}

/// Marks the cells from one place to another, cell by cell (Amanatides and Woo, 1987), the last one as met.
void OccupancyGrid::trace(double x0_m, double y0_m, double x1_m, double y1_m, bool met) {
  const auto cell_of = [this](double m) { return static_cast<int>(std::floor(m / cell_m_)); };
  int x = cell_of(x0_m), y = cell_of(y0_m);
  const int last_x = cell_of(x1_m), last_y = cell_of(y1_m);
  const double dx = x1_m - x0_m, dy = y1_m - y0_m;
  const int step_x = dx >= 0 ? 1 : -1, step_y = dy >= 0 ? 1 : -1;
  const auto first_crossing = [this](double from_m, double way_m, int cell, int step) {
    if (way_m == 0.0) return std::numeric_limits<double>::infinity();
    return ((cell + (step > 0 ? 1 : 0)) * cell_m_ - from_m) / way_m;
  };
  double next_x = first_crossing(x0_m, dx, x, step_x), next_y = first_crossing(y0_m, dy, y, step_y);
  const double per_x = dx != 0.0 ? cell_m_ / std::abs(dx) : 0.0, per_y = dy != 0.0 ? cell_m_ / std::abs(dy) : 0.0;
  int left = std::abs(last_x - x) + std::abs(last_y - y);
  Nearby nearby;
  for (; left > 0; --left) {
    mark(x, y, false, nearby);
    if (next_x <= next_y) {
      x += step_x;
      next_x += per_x;
    } else {
      y += step_y;
      next_y += per_y;
    }
  }
  mark(last_x, last_y, met, nearby);
}

void OccupancyGrid::add(const Scan& scan, const Eigen::Vector3d& place, const Eigen::Quaterniond& attitude,
                        double clear_max_m) {
  ++scans_;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double angle = scan.angle_min_rad + static_cast<double>(i) * scan.angle_step_rad;
    const double range_m = static_cast<double>(scan.ranges_m[i]);
    const bool met = std::isfinite(range_m);
    const Eigen::Vector3d way = attitude * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    const Eigen::Vector3d end = place + way * (met ? range_m : clear_max_m);
    trace(place.x(), place.y(), end.x(), end.y(), met);
  }
}

double OccupancyGrid::probability_at(double x_m, double y_m) const {
  const int x = static_cast<int>(std::floor(x_m / cell_m_)), y = static_cast<int>(std::floor(y_m / cell_m_));
  const int tile_x = floor_div(x, kTileSide), tile_y = floor_div(y, kTileSide);
  const auto tile = tiles_.find({tile_y, tile_x});
  if (tile == tiles_.end()) return 0.5;
  const Cell& c = tile->second[static_cast<std::size_t>((y - tile_y * kTileSide) * kTileSide + x - tile_x * kTileSide)];
  return 1.0 / (1.0 + std::exp(-static_cast<double>(c.log_odds)));
}

OccupancyPicture OccupancyGrid::picture() const {
  OccupancyPicture picture;
  picture.cell_m = cell_m_;
  int x_min = std::numeric_limits<int>::max(), y_min = x_min, x_max = std::numeric_limits<int>::min(), y_max = x_max;
  const auto each_seen = [this](auto&& visit) {
    for (const auto& [key, tile] : tiles_)
      for (int k = 0; k < kTileSide * kTileSide; ++k)
        if (const Cell& c = tile[static_cast<std::size_t>(k)]; c.scan != 0)
          visit(key.second * kTileSide + k % kTileSide, key.first * kTileSide + k / kTileSide, c);
  };
  each_seen([&](int x, int y, const Cell&) {
    x_min = std::min(x_min, x);
    x_max = std::max(x_max, x);
    y_min = std::min(y_min, y);
    y_max = std::max(y_max, y);
  });
  if (x_min > x_max) return picture;
  picture.width = x_max - x_min + 1;
  picture.height = y_max - y_min + 1;
  picture.x_min_m = (x_min + 0.5) * cell_m_;
  picture.y_min_m = (y_min + 0.5) * cell_m_;
  picture.probability_percent.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                                     OccupancyPicture::kUnseen);
  each_seen([&](int x, int y, const Cell& c) {
    const double probability = 1.0 / (1.0 + std::exp(-static_cast<double>(c.log_odds)));
    picture.probability_percent[static_cast<std::size_t>(y - y_min) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(x - x_min)] =
        static_cast<std::uint8_t>(std::lround(100.0 * probability));
  });
  return picture;
}

}  // namespace adit::sim
