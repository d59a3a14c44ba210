#include <fmt/format.h>

#include <cmath>
#include <set>

#include "adit/sim/course.hpp"
#include "adit/sim/course_fields.hpp"

namespace adit::sim {
namespace {

/// Finds the first number that is out of its range.
struct RangeCheck {
  std::optional<std::string> fault;

  template <class Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const FieldNote& note, const Number& value) { check(note, static_cast<double>(value)); }
  void operator()(const FieldNote& note, const LayoutKind& value) { check(note, static_cast<double>(value)); }
  void operator()(const FieldNote&, const std::string&) {}

 private:
  void check(const FieldNote& note, double value) {
    if (fault || (value >= note.minimum && value <= note.maximum)) return;
    fault = fmt::format("{} is {}; give {} to {}{}{}", note.name, value, note.minimum, note.maximum,
                        *note.unit != '\0' ? " " : "", note.unit);
  }
};

std::optional<std::string> outside(const std::string& where, const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return std::nullopt;
  return fmt::format("{}: {} is {}; give {} to {}", where, name, value, low, high);
}

std::optional<std::string> fault_of(const Move& move, const std::string& where) {
  const bool is_arc = move.turn_deg != 0.0;
  if (is_arc && move.straight_m != 0.0)
    return fmt::format("{}: a move has either straight_m or turn_deg, not both", where);
  if (!is_arc && move.straight_m == 0.0)
    return fmt::format("{}: a move needs straight_m, or turn_deg with radius_m", where);
  if (is_arc) {
    if (auto fault = outside(where, "turn_deg", move.turn_deg, -360.0, 360.0)) return fault;
    if (auto fault = outside(where, "radius_m", move.radius_m, 1.0, 1000.0)) return fault;
  } else if (auto fault = outside(where, "straight_m", move.straight_m, 0.5, 1000.0)) {
    return fault;
  }
  const double length_m = is_arc ? std::abs(move.turn_deg) * 0.0174533 * move.radius_m : move.straight_m;
  if (auto fault = outside(where, "rise_m", move.rise_m, -0.6 * length_m, 0.6 * length_m)) return fault;
  if (move.width_m != 0.0)
    if (auto fault = outside(where, "width_m", move.width_m, 1.2, 60.0)) return fault;
  if (move.height_m != 0.0)
    if (auto fault = outside(where, "height_m", move.height_m, 1.2, 30.0)) return fault;
  return std::nullopt;
}

std::optional<std::string> fault_of(const PassagePlan& plan) {
  const std::string where = "passage to '" + plan.to + "'";
  if (plan.to.empty()) return "a passage has no `to`; name the node it leads to";
  if (plan.moves.empty()) return where + " has no moves; give at least one";
  if (plan.width_m != 0.0)
    if (auto fault = outside(where, "width_m", plan.width_m, 1.2, 60.0)) return fault;
  if (plan.height_m != 0.0)
    if (auto fault = outside(where, "height_m", plan.height_m, 1.2, 30.0)) return fault;
  if (plan.heading_deg)
    if (auto fault = outside(where, "heading_deg", *plan.heading_deg, -360.0, 360.0)) return fault;
  for (const Move& move : plan.moves)
    if (auto fault = fault_of(move, where)) return fault;
  return std::nullopt;
}

std::optional<std::string> fault_of_lists(const CourseConfig& config) {
  for (const PassagePlan& plan : config.passages)
    if (auto fault = fault_of(plan)) return fault;
  for (const RoomPlan& room : config.rooms) {
    if (auto fault = outside("room", "width_m", room.width_m, 2.0, 60.0)) return fault;
    if (auto fault = outside("room", "height_m", room.height_m, 2.0, 30.0)) return fault;
  }
  for (const LampPlan& lamp : config.lamps) {
    if (auto fault = outside("lamp", "flux_lm", lamp.flux_lm, 10.0, 20000.0)) return fault;
    if (auto fault = outside("lamp", "emitter_radius_m", lamp.emitter_radius_m, 0.01, 0.5)) return fault;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of(const CourseConfig& config) {
  RangeCheck check;
  visit_fields(config, check);
  if (check.fault) return check.fault;
  if (config.width_min_m > config.width_max_m)
    return fmt::format("width_min_m is {} and width_max_m is {}; the first must not be larger", config.width_min_m,
                       config.width_max_m);
  if (config.layout == LayoutKind::kMoves && config.passages.empty())
    return "layout is moves, but there are no passages; list at least one";
  if (config.layout == LayoutKind::kTiles && config.tiles.empty())
    return "layout is tiles, but there are no tiles; list at least one";
  return fault_of_lists(config);
}

}  // namespace adit::sim
