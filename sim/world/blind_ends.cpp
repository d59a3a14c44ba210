#include "blind_ends.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace adit::sim {
namespace {

/// The goal lies at this share of the last passage, the mouth at its end.
constexpr double kGoalShare = 0.6;

std::size_t goal_point(const Passage& passage) {
  return static_cast<std::size_t>(kGoalShare * static_cast<double>(passage.axis.size()));
}

double length_m(const Passage& passage, std::size_t points) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < points; ++i)
    length_m += static_cast<double>((passage.axis[i].place - passage.axis[i - 1].place).norm());
  return length_m;
}

/// The passage is cut at the goal; what lies behind it runs out of the rock.
void open_up(Layout& layout, std::size_t index) {
  Passage outer = layout.passages[index];
  layout.mouths.push_back(mouth_at(outer.axis.back(), outer.axis[outer.axis.size() - 2], false));
  const std::size_t cut = goal_point(outer);
  layout.nodes.push_back({NodeKind::kGoal, outer.axis[cut].place});
  outer.from = static_cast<int>(layout.nodes.size()) - 1;
  outer.axis.erase(outer.axis.begin(), outer.axis.begin() + static_cast<std::ptrdiff_t>(cut));
  Passage& inner = layout.passages[index];
  inner.to = outer.from;
  inner.axis.resize(cut + 1);
  layout.passages.insert(layout.passages.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(outer));
}

}  // namespace

Mouth mouth_at(const AxisPoint& end, const AxisPoint& inner, bool has_apron) {
  const Eigen::Vector3f out = end.place - inner.place;
  return {end.place, Eigen::Vector2f(out.x(), out.y()).normalized(), end.width_m, end.height_m, has_apron};
}

std::vector<double> ways_from(const Layout& layout, int node) {
  std::vector<double> ways_m(layout.nodes.size(), std::numeric_limits<double>::infinity());
  ways_m[static_cast<std::size_t>(node)] = 0.0;
  for (bool is_changed = true; is_changed;) {  // Bellman and Ford: networks are small
    is_changed = false;
    for (const Passage& passage : layout.passages) {
      const double way_m = length_m(passage, passage.axis.size());
      double& from_m = ways_m[static_cast<std::size_t>(passage.from)];
      double& to_m = ways_m[static_cast<std::size_t>(passage.to)];
      is_changed = is_changed || from_m + way_m < to_m || to_m + way_m < from_m;
      to_m = std::min(to_m, from_m + way_m);
      from_m = std::min(from_m, to_m + way_m);
    }
  }
  return ways_m;
}

void lead_out(Layout& layout, int entrance, double goal_min_m) {
  const std::vector<double> ways_m = ways_from(layout, entrance);
  const auto kind_of = [&](int node) -> NodeKind& { return layout.nodes[static_cast<std::size_t>(node)].kind; };
  const auto is_blind = [&](const Passage& passage) {
    return passage.to != entrance &&
           (kind_of(passage.to) == NodeKind::kMouth || kind_of(passage.to) == NodeKind::kDeadEnd);
  };
  std::optional<int> furthest;
  double furthest_m = 0.0;
  bool is_open = false;
  for (const Passage& passage : layout.passages) {
    if (!is_blind(passage)) continue;
    const double goal_m = ways_m[static_cast<std::size_t>(passage.from)] + length_m(passage, goal_point(passage) + 1);
    if (!furthest || goal_m > furthest_m) {
      furthest = passage.to;
      furthest_m = goal_m;
    }
    if (kind_of(passage.to) != NodeKind::kMouth) continue;
    if (goal_m < goal_min_m) kind_of(passage.to) = NodeKind::kDeadEnd;
    is_open = is_open || goal_m >= goal_min_m;
  }
  if (!is_open && furthest) kind_of(*furthest) = NodeKind::kMouth;
  for (std::size_t i = 0; i < layout.passages.size(); ++i) {
    if (!is_blind(layout.passages[i]) || kind_of(layout.passages[i].to) != NodeKind::kMouth) continue;
    open_up(layout, i);
    ++i;
  }
}

}  // namespace adit::sim
