#include "adit/sim/bend_count.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::sim {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double between_deg(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * std::numbers::pi)) * kDegrees;
}

/// The angle that looks like `angle_rad` and is nearest to `near_deg`.
double unwound_deg(double angle_rad, double near_deg) {
  return near_deg + std::remainder(angle_rad * kDegrees - near_deg, 360.0);
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
  see_passage(flown_m, passage_rad);
  if (flown_m - way_.front().first < kStraight_m) return;
  while (flown_m - way_[1].first >= kStraight_m) way_.pop_front();
  const Eigen::Vector2d chord = here - way_.front().second;
  const double directness = chord.norm() / (flown_m - way_.front().first);
  if (directness < kCourseness) return;
  const double course_rad = std::atan2(chord.y(), chord.x());
  const bool is_straight =
      directness >= kStraightness && between_deg(course_rad, passage_rad) < kAlongPassage_deg;  // false for NaN
  const Directions now = directions(flown_m, course_rad);
  last_course_deg_ = now.course_deg;
  judge(now, is_straight);
}

void BendCount::see_passage(double flown_m, double passage_rad) {
  if (!std::isnan(passage_rad))
    passages_.emplace_back(
        flown_m, passages_.empty() ? passage_rad * kDegrees : unwound_deg(passage_rad, passages_.back().second));
  while (passages_.size() > 1 && flown_m - passages_.front().first > kLead_m) passages_.pop_front();
}

BendCount::Directions BendCount::directions(double flown_m, double course_rad) const {
  Directions now;
  now.flown_m = flown_m;
  now.course_deg = last_course_deg_ ? unwound_deg(course_rad, *last_course_deg_) : course_rad * kDegrees;
  if (passages_.empty()) return now;
  now.passage_low_deg = now.passage_high_deg = passages_.back().second;
  for (const auto& [at_m, passage_deg] : passages_) {
    now.passage_low_deg = std::min(now.passage_low_deg, passage_deg);
    now.passage_high_deg = std::max(now.passage_high_deg, passage_deg);
  }
  return now;
}

/// Whether course and passage have turned alike since the beginning.
bool BendCount::turned(const Directions& to) const {
  if (to.course_deg - begin_->course_deg >= kTurn_deg)
    return to.passage_high_deg - begin_->passage_low_deg >= kTurn_deg;
  return begin_->course_deg - to.course_deg >= kTurn_deg && begin_->passage_high_deg - to.passage_low_deg >= kTurn_deg;
}

/// Whether the bend that was counted last goes on: then its end is the beginning of what comes.
bool BendCount::turns_on(const Directions& now) {
  if (sense_ == 0) return false;
  if (sense_ * (now.course_deg - steady_.course_deg) >= kSteady_deg)
    steady_ = now;
  else if (now.flown_m - steady_.flown_m > kStraight_m)
    sense_ = 0;
  return sense_ * (now.course_deg - begin_->course_deg) > 0.0;
}

void BendCount::begin_at(const Directions& place, const Directions& now) {
  begin_ = left_ = right_ = place;
  if (now.course_deg > left_.course_deg) left_ = now;
  if (now.course_deg < right_.course_deg) right_ = now;
}

/// A bend that ends at `end`, or a turning back.
void BendCount::pass(const Directions& end, const Directions& now, bool is_straight) {
  const double turned_deg = end.course_deg - begin_->course_deg;
  if (std::abs(turned_deg) < kBack_deg) ++bends_;
  sense_ = turned_deg > 0.0 ? 1 : -1;
  steady_ = end;
  begins_straight_ = is_straight;
  begin_at(end, now);
}

void BendCount::judge(const Directions& now, bool is_straight) {
  if (!begin_) {
    if (is_straight) begin_at(now, now);
    return;
  }
  if (turns_on(now)) return begin_at(now, now);
  if (now.course_deg >= left_.course_deg) left_ = now;
  if (now.course_deg <= right_.course_deg) right_ = now;
  const double turned_deg = std::abs(now.course_deg - begin_->course_deg);
  if (is_straight && (begins_straight_ ? turned_deg >= kBend_deg : turned(now))) return pass(now, now, true);
  for (const Directions& furthest : {left_, right_})
    if (std::abs(now.course_deg - furthest.course_deg) >= kOther_deg && turned(furthest))
      return pass(furthest, now, false);
}

}  // namespace adit::sim
