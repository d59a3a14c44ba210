// A network of any length: crossings on a jittered grid, joined outward from the entrance, with loops and blind ends.
#include <algorithm>
#include <cmath>
#include <map>

#include "blind_ends.hpp"
#include "layout.hpp"
#include "noise.hpp"

namespace adit::sim {
namespace {

/// Rounds of cutting corners (Chaikin 1974): two make curves out of corners.
constexpr int kCornerRounds = 3;
constexpr double kAxisStep_m = 0.5;
/// A blind end is a dead end with this chance, or else a way out.
constexpr double kDeadEndShare = 0.35;
constexpr int kEntrance = 0;  ///< its crossing, and its node

struct Crossing {
  Eigen::Vector3d place;
  double width_m = 5.0;
  std::vector<std::size_t> links;
};

struct Link {
  std::size_t from, to;
  double bulge_m;  ///< to the left, half way
  bool is_used = false;
};

class NetworkGrowth {
 public:
  explicit NetworkGrowth(const CourseConfig& config)
      : config_(config), row_(static_cast<std::uint32_t>(config.seed) ^ 0x4e77u) {}

  Layout grown() {
    grow();
    layout_.passages.reserve(links_.size() + crossings_.size());
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      if (crossings_[i].links.size() != 2) ends.push_back(i);
    for (const std::size_t end : ends)  // the entrance is crossing 0 and comes first
      for (const std::size_t link : crossings_[end].links)
        if (!links_[link].is_used) follow(end, link);
    lead_out(layout_, kEntrance, config_.goal_min_m);
    return std::move(layout_);
  }

 private:
  using Cell = std::pair<int, int>;

  std::size_t add_crossing(const Cell& cell, const Eigen::Vector3d& place) {
    Crossing crossing{.place = place, .width_m = row_.uniform(config_.width_min_m, config_.width_max_m), .links = {}};
    crossings_.push_back(crossing);
    cells_[cell] = crossings_.size() - 1;
    order_.push_back(cell);
    return crossings_.size() - 1;
  }

  void add_link(std::size_t from, std::size_t to) {
    const double bulge_m = row_.uniform(-0.1, 0.1) * config_.grid_m;
    crossings_[from].links.push_back(links_.size());
    crossings_[to].links.push_back(links_.size());
    links_.push_back({from, to, bulge_m});
    length_m_ += (crossings_[from].place - crossings_[to].place).norm();
  }

  Eigen::Vector3d place_of(const Cell& cell, double from_z) {
    const double jitter_m = 0.15 * config_.grid_m;
    return {cell.first * config_.grid_m + row_.uniform(-jitter_m, jitter_m),
            cell.second * config_.grid_m + row_.uniform(-jitter_m, jitter_m),
            from_z + row_.uniform(-0.7, 0.7) * config_.grade_max * config_.grid_m};
  }

  void grow() {
    add_crossing({0, 0}, Eigen::Vector3d::Zero());
    crossings_[0].width_m = config_.width_m;
    const std::size_t first = add_crossing({1, 0}, {config_.grid_m, 0.0, 0.0});
    add_link(0, first);
    links_[0].bulge_m = 0.0;
    Cell head{1, 0};
    while (length_m_ < config_.length_m) {
      // Mostly on from where the last one ended, now and then from anywhere: long ways with branches.
      if (row_.chance(config_.branch_probability)) head = order_[1 + row_.next() % (order_.size() - 1)];
      head = stepped(head);
    }
  }

  /// One passage from a crossing to a free neighbour, or, where there is one beside it already, a loop.
  Cell stepped(const Cell& from) {
    constexpr Cell kWays[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const Cell way = kWays[row_.next() % 4];
    const Cell to{from.first + way.first, from.second + way.second};
    // The column of the entrance stays rock, so that its mouth is free.
    if (to.first < 1) return order_[1 + row_.next() % (order_.size() - 1)];
    const std::size_t here = cells_[from];
    const auto found = cells_.find(to);
    if (found == cells_.end()) {
      add_link(here, add_crossing(to, place_of(to, crossings_[here].place.z())));
      return to;
    }
    if (row_.chance(0.15) && !are_linked(here, found->second) && is_gentle(here, found->second))
      add_link(here, found->second);
    return to;
  }

  bool are_linked(std::size_t a, std::size_t b) const {
    return std::any_of(crossings_[a].links.begin(), crossings_[a].links.end(),
                       [&](std::size_t link) { return links_[link].from == b || links_[link].to == b; });
  }
  bool is_gentle(std::size_t a, std::size_t b) const {
    const Eigen::Vector3d way = crossings_[b].place - crossings_[a].place;
    return std::abs(way.z()) < config_.grade_max * way.head<2>().norm();
  }

  int node_of(std::size_t crossing) {
    const auto [found, is_new] = nodes_.try_emplace(crossing, static_cast<int>(layout_.nodes.size()));
    if (is_new) {
      NodeKind kind = NodeKind::kJunction;
      if (crossing == kEntrance)
        kind = NodeKind::kMouth;
      else if (crossings_[crossing].links.size() == 1)
        kind = row_.chance(kDeadEndShare) ? NodeKind::kDeadEnd : NodeKind::kMouth;
      layout_.nodes.push_back({kind, crossings_[crossing].place.cast<float>()});
    }
    return found->second;
  }

  using Corner = Eigen::Vector4d;  ///< place and width

  Corner corner_of(std::size_t crossing) const {
    const Crossing& c = crossings_[crossing];
    return {c.place.x(), c.place.y(), c.place.z(), c.width_m};
  }

  void follow(std::size_t from, std::size_t link) {
    std::vector<Corner> corners{corner_of(from)};
    std::size_t at = from;
    while (true) {
      Link& along = links_[link];
      along.is_used = true;
      const std::size_t to = along.from == at ? along.to : along.from;
      const Corner a = corner_of(at), b = corner_of(to);
      const Eigen::Vector2d way = (b - a).head<2>().normalized();
      const double bulge_m = along.from == at ? along.bulge_m : -along.bulge_m;
      Corner middle = 0.5 * (a + b);
      middle.head<2>() += bulge_m * Eigen::Vector2d(-way.y(), way.x());
      corners.push_back(middle);
      corners.push_back(b);
      at = to;
      const auto& links = crossings_[at].links;
      if (links.size() != 2 || at == from) break;
      link = links[0] == link ? links[1] : links[0];
      if (links_[link].is_used) break;
    }
    // One after the other: in which order a call's arguments are worked out is the compiler's choice.
    const int first = node_of(from);
    const int last = node_of(at);
    add_passage(first, last, axis_of(rounded(std::move(corners))), crossings_[from].links.size() == 1);
  }

  static std::vector<Corner> rounded(std::vector<Corner> corners) {
    for (int round = 0; round < kCornerRounds; ++round) {
      std::vector<Corner> next{corners.front()};
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        if (i > 0) next.push_back(0.75 * corners[i] + 0.25 * corners[i + 1]);
        if (i + 2 < corners.size()) next.push_back(0.25 * corners[i] + 0.75 * corners[i + 1]);
      }
      next.push_back(corners.back());
      corners = std::move(next);
    }
    return corners;
  }

  std::vector<AxisPoint> axis_of(const std::vector<Corner>& corners) const {
    std::vector<AxisPoint> axis;
    const auto push = [&](const Corner& c) {
      axis.push_back({c.head<3>().cast<float>(), static_cast<float>(c[3]),
                      static_cast<float>(c[3] * config_.height_m / config_.width_m)});
    };
    push(corners.front());
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const double length_m = (corners[i + 1] - corners[i]).head<3>().norm();
      const int steps = std::max(1, static_cast<int>(std::lround(length_m / kAxisStep_m)));
      for (int k = 1; k <= steps; ++k) push(corners[i] + (corners[i + 1] - corners[i]) * k / steps);
    }
    return axis;
  }

  /// Blind ends are where their passages end; the entrance is where the first one begins.
  void add_passage(int from, int to, std::vector<AxisPoint> axis, bool begins_blind) {
    if (from == kEntrance) {
      layout_.mouths.push_back(mouth_at(axis[0], axis[1], config_.apron_m > 0.0));
    } else if (begins_blind) {
      std::swap(from, to);
      std::reverse(axis.begin(), axis.end());
    }
    layout_.passages.push_back({from, to, std::move(axis)});
  }

  const CourseConfig& config_;
  SeededRow row_;
  double length_m_ = 0.0;
  std::vector<Crossing> crossings_;
  std::vector<Link> links_;
  std::map<Cell, std::size_t> cells_;
  std::vector<Cell> order_;
  std::map<std::size_t, int> nodes_;
  Layout layout_;
};

}  // namespace

Layout lay_out_network(const CourseConfig& config) { return NetworkGrowth(config).grown(); }

}  // namespace adit::sim
