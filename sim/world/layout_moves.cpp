#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "adit/sim/world_error.hpp"
#include "layout.hpp"

namespace adit::sim {
namespace {

constexpr double kDegrees = std::numbers::pi / 180.0;

/// A node that passages may begin at.
struct OpenEnd {
  int node = -1;
  AxisHead head;
};

class MoveLayout {
 public:
  explicit MoveLayout(const CourseConfig& config) : config_(config) {}

  Layout laid_out() {
    AxisHead head{.width_m = config_.width_m, .height_m = config_.height_m};
    if (!config_.passages.empty()) {
      const PassagePlan& first = config_.passages.front();
      head.yaw_rad = first.heading_deg.value_or(0.0) * kDegrees;
      if (first.width_m > 0.0) head.width_m = first.width_m;
      if (first.height_m > 0.0) head.height_m = first.height_m;
    }
    ends_["start"] = {add_node(NodeKind::kMouth, head), head};
    add_mouth(head, -1.0, config_.apron_m > 0.0);
    for (const PassagePlan& plan : config_.passages) add_passage(plan);
    for (const RoomPlan& room : config_.rooms)
      layout_.rooms.push_back({Eigen::Vector3d(room.x_m, room.y_m, room.z_m).cast<float>(),
                               static_cast<float>(room.width_m), static_cast<float>(room.height_m)});
    return std::move(layout_);
  }

 private:
  int add_node(NodeKind kind, const AxisHead& head) {
    layout_.nodes.push_back({kind, head.place.cast<float>()});
    return static_cast<int>(layout_.nodes.size()) - 1;
  }

  /// @param sense  1: the passage runs out of the rock here, -1: into it.
  void add_mouth(const AxisHead& head, double sense, bool has_apron) {
    const Eigen::Vector2d outward(sense * std::cos(head.yaw_rad), sense * std::sin(head.yaw_rad));
    layout_.mouths.push_back({head.place.cast<float>(), outward.cast<float>(), static_cast<float>(head.width_m),
                              static_cast<float>(head.height_m), has_apron});
  }

  void add_passage(const PassagePlan& plan) {
    const auto from = ends_.find(plan.from);
    if (from == ends_.end())
      throw WorldError(fmt::format("{}: passage to '{}' begins at '{}', which no passage before it has made",
                                   config_.name, plan.to, plan.from));
    if (ends_.contains(plan.to))
      throw WorldError(
          fmt::format("{}: node '{}' is made twice; give each passage an end of its own", config_.name, plan.to));
    AxisHead head = from->second.head;
    if (plan.heading_deg) head.yaw_rad = *plan.heading_deg * kDegrees;
    if (plan.width_m > 0.0) head.width_m = plan.width_m;
    if (plan.height_m > 0.0) head.height_m = plan.height_m;
    Passage passage;
    passage.from = from->second.node;
    for (const Move& move : plan.moves) append_move(move, head, passage.axis);
    passage.to = add_node(plan.end, head);
    layout_.passages.push_back(std::move(passage));
    ends_[plan.to] = {layout_.passages.back().to, head};
    if (plan.end == NodeKind::kMouth) add_mouth(head, 1.0, false);
    if (plan.end == NodeKind::kGoal) add_run_out(layout_.passages.back().to, head);
  }

  void add_run_out(int goal, AxisHead head) {
    Passage passage;
    passage.from = goal;
    append_move({.straight_m = config_.run_out_m}, head, passage.axis);
    passage.to = add_node(NodeKind::kMouth, head);
    layout_.passages.push_back(std::move(passage));
    add_mouth(head, 1.0, false);
  }

  const CourseConfig& config_;
  Layout layout_;
  std::map<std::string, OpenEnd> ends_;
};

}  // namespace

Layout lay_out_moves(const CourseConfig& config) { return MoveLayout(config).laid_out(); }

}  // namespace adit::sim
