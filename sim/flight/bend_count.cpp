#include "adit/sim/bend_count.hpp"

#include <cmath>
#include <numbers>

namespace adit::sim {
namespace {

double between_deg(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * std::numbers::pi)) * 180.0 / std::numbers::pi;
}

}  // namespace

void BendCount::add(const Eigen::Vector3d& place, double passage_rad) {
  const Eigen::Vector2d here = place.head<2>();
  if (way_.empty()) {
    way_.emplace_back(0.0, here);
    return;
  }
  constexpr double kStep_m = 0.25;  // finer, and hovering in gusts would make a way of its own
  const double step_m = (here - way_.back().second).norm();
  if (step_m < kStep_m) return;
  const double flown_m = way_.back().first + step_m;
  way_.emplace_back(flown_m, here);
  if (flown_m - way_.front().first < kStraight_m) return;
  while (flown_m - way_[1].first >= kStraight_m) way_.pop_front();
  const Eigen::Vector2d chord = here - way_.front().second;
  if (chord.norm() < kStraightness * (flown_m - way_.front().first)) return;
  const double course_rad = std::atan2(chord.y(), chord.x());
  if (!(between_deg(course_rad, passage_rad) < kAlongPassage_deg)) return;
  if (!course_rad_) course_rad_ = course_rad;
  const double turned_deg = between_deg(course_rad, *course_rad_);
  if (turned_deg < kBend_deg) return;
  if (turned_deg < kBack_deg) ++bends_;
  course_rad_ = course_rad;
}

}  // namespace adit::sim
