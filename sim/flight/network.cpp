#include "adit/sim/network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace adit::sim {
namespace {

using Eigen::Vector3d;

constexpr double kNever_m = std::numeric_limits<double>::infinity();
constexpr int kDepthMax = 64;  // nodes in a row; keeps rings of very short passages from running on

Vector3d place_of(const AxisPoint& point) { return point.place.cast<double>(); }

}  // namespace

/// One step of a walk: on a passage, at a place, forwards or backwards, with some way left.
struct Network::Walk {
  int passage = -1;
  double along_m = 0.0;
  bool forwards = true;
  double left_m = 0.0;
  int depth = 0;
};

Network::Network(const World& world) : nodes_(world.nodes), lines_at_(world.nodes.size()) {
  const auto known = [this](int node) { return node >= 0 && node < static_cast<int>(nodes_.size()); };
  for (std::size_t i = 0; i < world.passages.size(); ++i) {
    const Passage& passage = world.passages[i];
    if (passage.axis.size() < 2 || !known(passage.from) || !known(passage.to)) continue;
    Line line{passage.from, passage.to, passage.axis, {0.0}};
    for (std::size_t k = 1; k < line.axis.size(); ++k)
      line.along_m.push_back(line.along_m.back() + (place_of(line.axis[k]) - place_of(line.axis[k - 1])).norm());
    if (!(line.length_m() > 0.0)) continue;
    const int index = static_cast<int>(passages_.size());
    lines_at_[static_cast<std::size_t>(line.from)].push_back(index);
    if (line.to != line.from) lines_at_[static_cast<std::size_t>(line.to)].push_back(index);
    passages_.push_back(std::move(line));
    source_index_.push_back(static_cast<int>(i));
  }
  goal_ways_m_.assign(nodes_.size(), kNever_m);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].kind != NodeKind::kGoal) continue;
    goal_ways_m_[i] = 0.0;
    has_goal_ = true;
  }
  distances_from(goal_ways_m_);
}

/// Dijkstra from all nodes whose way is known.
void Network::distances_from(std::vector<double>& ways_m) const {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t i = 0; i < ways_m.size(); ++i)
    if (ways_m[i] < kNever_m) open.emplace(ways_m[i], static_cast<int>(i));
  while (!open.empty()) {
    const auto [way_m, node] = open.top();
    open.pop();
    if (way_m > ways_m[static_cast<std::size_t>(node)]) continue;
    for (const int index : lines_at_[static_cast<std::size_t>(node)]) {
      const Line& line = passages_[static_cast<std::size_t>(index)];
      const int other = line.from == node ? line.to : line.from;
      const double next_m = way_m + line.length_m();
      if (next_m >= ways_m[static_cast<std::size_t>(other)]) continue;
      ways_m[static_cast<std::size_t>(other)] = next_m;
      open.emplace(next_m, other);
    }
  }
}

AxisPlace Network::at(int passage, double along_m) const {
  const Line& line = passages_[static_cast<std::size_t>(passage)];
  const auto after = std::upper_bound(line.along_m.begin() + 1, line.along_m.end() - 1, along_m);
  const auto k = static_cast<std::size_t>(after - line.along_m.begin());
  const double span_m = line.along_m[k] - line.along_m[k - 1];
  const double share = span_m > 0.0 ? std::clamp((along_m - line.along_m[k - 1]) / span_m, 0.0, 1.0) : 0.0;
  const AxisPoint &a = line.axis[k - 1], &b = line.axis[k];
  AxisPlace place;
  place.passage = passage;
  place.along_m = std::clamp(along_m, 0.0, line.length_m());
  place.place = place_of(a) + share * (place_of(b) - place_of(a));
  place.tangent = (place_of(b) - place_of(a)).normalized();
  place.width_m = a.width_m + share * (b.width_m - a.width_m);
  place.height_m = a.height_m + share * (b.height_m - a.height_m);
  return place;
}

AxisPlace Network::nearest(const Vector3d& point) const {
  double best = kNever_m, best_along_m = 0.0;
  int best_line = 0;
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    const Line& line = passages_[i];
    for (std::size_t k = 1; k < line.axis.size(); ++k) {
      const Vector3d a = place_of(line.axis[k - 1]), ab = place_of(line.axis[k]) - a;
      const double squared = ab.squaredNorm();
      const double share = squared > 0.0 ? std::clamp((point - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
      const double distance = (a + share * ab - point).squaredNorm();
      if (distance >= best) continue;
      best = distance;
      best_line = static_cast<int>(i);
      best_along_m = line.along_m[k - 1] + share * (line.along_m[k] - line.along_m[k - 1]);
    }
  }
  AxisPlace place = at(best_line, best_along_m);
  place.aside_m = (point - place.place).head<2>().norm();
  return place;
}

bool Network::is_mouth(const AxisPlace& place) const {
  const Line& line = passages_[static_cast<std::size_t>(place.passage)];
  const auto kind_of = [this](int node) { return nodes_[static_cast<std::size_t>(node)].kind; };
  return (place.along_m <= 0.0 && kind_of(line.from) == NodeKind::kMouth) ||
         (place.along_m >= line.length_m() && kind_of(line.to) == NodeKind::kMouth);
}

double Network::to_goal_m(const AxisPlace& from) const {
  const Line& line = passages_[static_cast<std::size_t>(from.passage)];
  return std::min(goal_ways_m_[static_cast<std::size_t>(line.from)] + from.along_m,
                  goal_ways_m_[static_cast<std::size_t>(line.to)] + line.length_m() - from.along_m);
}

double Network::between_m(const AxisPlace& from, const AxisPlace& to) const {
  const Line& start = passages_[static_cast<std::size_t>(from.passage)];
  const Line& end = passages_[static_cast<std::size_t>(to.passage)];
  std::vector<double> ways_m(nodes_.size(), kNever_m);
  ways_m[static_cast<std::size_t>(start.from)] = from.along_m;
  auto& last = ways_m[static_cast<std::size_t>(start.to)];
  last = std::min(last, start.length_m() - from.along_m);
  distances_from(ways_m);
  double way_m = std::min(ways_m[static_cast<std::size_t>(end.from)] + to.along_m,
                          ways_m[static_cast<std::size_t>(end.to)] + end.length_m() - to.along_m);
  if (from.passage == to.passage) way_m = std::min(way_m, std::abs(from.along_m - to.along_m));
  return way_m;
}

void Network::walk(const Walk& w, std::vector<Ahead>& found) const {
  const Line& line = passages_[static_cast<std::size_t>(w.passage)];
  const double room_m = w.forwards ? line.length_m() - w.along_m : w.along_m;
  if (w.left_m <= room_m) {
    const AxisPlace place = at(w.passage, w.along_m + (w.forwards ? w.left_m : -w.left_m));
    found.push_back({place.place, source_index_[static_cast<std::size_t>(w.passage)], false, NodeKind::kBend});
    return;
  }
  const int node = w.forwards ? line.to : line.from;
  const auto& onward = lines_at_[static_cast<std::size_t>(node)];
  bool ends = true;
  for (const int next : onward) {
    if (next == w.passage || w.depth >= kDepthMax) continue;
    ends = false;
    const bool forwards = passages_[static_cast<std::size_t>(next)].from == node;
    walk({next, forwards ? 0.0 : passages_[static_cast<std::size_t>(next)].length_m(), forwards, w.left_m - room_m,
          w.depth + 1},
         found);
  }
  if (ends)
    found.push_back({nodes_[static_cast<std::size_t>(node)].place.cast<double>(),
                     source_index_[static_cast<std::size_t>(w.passage)], true,
                     nodes_[static_cast<std::size_t>(node)].kind});
}

std::vector<Ahead> Network::ahead(const AxisPlace& from, const Vector3d& heading, double length_m) const {
  std::vector<Ahead> found;
  walk({from.passage, from.along_m, from.tangent.dot(heading) >= 0.0, length_m, 0}, found);
  return found;
}

void Network::walk_into_branches(const Walk& w, double into_m, std::vector<Ahead>& found) const {
  const Line& line = passages_[static_cast<std::size_t>(w.passage)];
  const double room_m = w.forwards ? line.length_m() - w.along_m : w.along_m;
  if (room_m > w.left_m || w.depth >= kDepthMax) return;
  const int node = w.forwards ? line.to : line.from;
  const auto& onward = lines_at_[static_cast<std::size_t>(node)];
  const double mouth_m = 0.5 * at(w.passage, w.forwards ? line.length_m() : 0.0).width_m;
  for (const int next : onward) {
    if (next == w.passage) continue;
    const Line& branch = passages_[static_cast<std::size_t>(next)];
    const bool forwards = branch.from == node;
    const double start_m = forwards ? 0.0 : branch.length_m();
    if (onward.size() > 2)
      walk({next, start_m, forwards, mouth_m + into_m, 0}, found);
    else
      walk_into_branches({next, start_m, forwards, w.left_m - room_m, w.depth + 1}, into_m, found);
  }
}

std::vector<Ahead> Network::branches(const AxisPlace& from, const Vector3d& heading, double range_m,
                                     double into_m) const {
  std::vector<Ahead> found;
  walk_into_branches({from.passage, from.along_m, from.tangent.dot(heading) >= 0.0, range_m, 0}, into_m, found);
  return found;
}

}  // namespace adit::sim
