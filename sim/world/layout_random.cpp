#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adit/sim/world_error.hpp"
#include "layout.hpp"
#include "noise.hpp"

namespace adit::sim {
namespace {

constexpr double kDegrees = std::numbers::pi / 180.0;
/// Rock that must stay between two stretches that are not neighbours.
constexpr double kPillar_m = 5.0;

/// One passage, move by move; a move that comes too near to what is there is drawn again.
class TunnelWalk {
 public:
  explicit TunnelWalk(const CourseConfig& config)
      : config_(config), row_(static_cast<std::uint32_t>(config.seed) ^ 0x7a11u) {}

  CourseConfig planned() {
    PassagePlan plan;
    plan.to = "goal";
    plan.end = NodeKind::kGoal;
    plan.width_m = row_.uniform(config_.width_min_m, config_.width_max_m);
    plan.height_m = plan.width_m * config_.height_m / config_.width_m;
    AxisHead head{.place = Eigen::Vector3d::Zero(), .width_m = plan.width_m, .height_m = plan.height_m};
    take({.straight_m = 8.0}, head, plan);
    const int tries_max = 5000 + static_cast<int>(2.0 * config_.length_m);
    int all_tries = 0;
    for (int tries = 0; length_m_ < config_.length_m; ++tries) {
      if (++all_tries > tries_max) give_up();
      if (tries > 200 && plan.moves.size() > 2) step_back(head, plan, tries);
      const Move move = drawn();
      if (fits(move, head)) {
        take(move, head, plan);
        tries = 0;
      }
    }
    CourseConfig planned = config_;
    planned.passages = {plan};
    return planned;
  }

 private:
  Move drawn() {
    Move move;
    double length_m = row_.uniform(3.0, 14.0);
    if (row_.chance(0.65)) {
      move.turn_deg = row_.uniform(15.0, std::max(15.0, config_.turn_max_deg)) * (row_.chance(0.5) ? 1.0 : -1.0);
      move.radius_m = config_.radius_min_m * row_.uniform(1.0, 2.5);
      length_m = std::abs(move.turn_deg) * kDegrees * move.radius_m;
    } else {
      move.straight_m = length_m;
    }
    move.rise_m = row_.uniform(-config_.grade_max, config_.grade_max) * length_m;
    move.width_m = row_.uniform(config_.width_min_m, config_.width_max_m);
    move.height_m = move.width_m * config_.height_m / config_.width_m;
    return move;
  }

  bool fits(const Move& move, AxisHead head) const {
    std::vector<AxisPoint> axis;
    append_move(move, head, axis);
    append_move({.straight_m = config_.run_out_m}, head, axis);  // there must be room for the end
    const double apart_m = config_.width_max_m + kPillar_m;
    const std::size_t near = std::min(axis_.size(), static_cast<std::size_t>(2.0 * 1.6 * apart_m));
    for (std::size_t k = axis.size(); k > 3; k -= 3)
      for (std::size_t i = 0; i + near < axis_.size(); i += 3)
        if ((axis[k - 1].place - axis_[i].place).head<2>().norm() < apart_m) return false;
    return true;
  }

  void take(const Move& move, AxisHead& head, PassagePlan& plan) {
    heads_.push_back(head);
    lengths_.push_back(length_m_);
    const std::size_t before = axis_.size();
    append_move(move, head, axis_);
    length_m_ += 0.5 * static_cast<double>(axis_.size() - before);
    points_.push_back(before);
    plan.moves.push_back(move);
  }

  /// Out of a corner: the last moves are taken back.
  void step_back(AxisHead& head, PassagePlan& plan, int& tries) {
    for (int i = 0; i < 3 && plan.moves.size() > 1; ++i) {
      head = heads_.back();
      length_m_ = lengths_.back();
      axis_.resize(points_.back());
      heads_.pop_back();
      lengths_.pop_back();
      points_.pop_back();
      plan.moves.pop_back();
    }
    tries = 0;
  }

  [[noreturn]] void give_up() const {
    throw WorldError(
        fmt::format("{}: no room for a tunnel of {} m; try another seed, a larger radius_min_m or a "
                    "smaller turn_max_deg",
                    config_.name, config_.length_m));
  }

  const CourseConfig& config_;
  SeededRow row_;
  double length_m_ = 0.0;
  std::vector<AxisPoint> axis_;
  std::vector<AxisHead> heads_;
  std::vector<double> lengths_;
  std::vector<std::size_t> points_;
};

}  // namespace

Layout lay_out_random(const CourseConfig& config) {
  return config.layout == LayoutKind::kRandomTunnel ? lay_out_moves(TunnelWalk(config).planned())
                                                    : lay_out_network(config);
}

}  // namespace adit::sim
