#include "adit/eval/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::eval {
namespace {

constexpr double kOnEdge_px = 1e-9;

Pixel nearest_on_edge(Pixel a, Pixel b, Pixel place) noexcept {
  const double du = b.u_px - a.u_px, dv = b.v_px - a.v_px;
  const double length2 = du * du + dv * dv;
  const double along = length2 > 0.0 ? ((place.u_px - a.u_px) * du + (place.v_px - a.v_px) * dv) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return {a.u_px + t * du, a.v_px + t * dv};
}

double distance_px(Pixel a, Pixel b) noexcept { return std::hypot(a.u_px - b.u_px, a.v_px - b.v_px); }

bool is_inside(const std::vector<Pixel>& corners, Pixel place) noexcept {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Pixel a = corners[i], b = corners[j];
    if ((a.v_px > place.v_px) == (b.v_px > place.v_px)) continue;
    const double u_px = a.u_px + (place.v_px - a.v_px) / (b.v_px - a.v_px) * (b.u_px - a.u_px);
    if (place.u_px < u_px) inside = !inside;
  }
  return inside;
}

Pixel nearest_edge_place(const std::vector<Pixel>& corners, Pixel place) noexcept {
  Pixel best = corners.front();
  double best_px = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Pixel candidate = nearest_on_edge(corners[j], corners[i], place);
    if (const double d_px = distance_px(candidate, place); d_px < best_px) {
      best_px = d_px;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

Outline box_of(Pixel a, Pixel b) { return {{{a.u_px, a.v_px}, {b.u_px, a.v_px}, {b.u_px, b.v_px}, {a.u_px, b.v_px}}}; }

bool contains(const Outline& outline, Pixel place) noexcept {
  if (outline.corners.empty()) return false;
  return is_inside(outline.corners, place) ||
         distance_px(nearest_edge_place(outline.corners, place), place) <= kOnEdge_px;
}

Pixel nearest_of(const Outline& outline, Pixel place) noexcept {
  if (outline.corners.empty() || contains(outline, place)) return place;
  return nearest_edge_place(outline.corners, place);
}

}  // namespace adit::eval
