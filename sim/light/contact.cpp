// What a sphere touches: closest point on the mesh, and first contact along a straight way.
#include <algorithm>
#include <cmath>

#include "embree.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;

/// The point of a triangle closest to p (Ericson, Real-Time Collision Detection, 5.1.5: by Voronoi regions).
Vector3f closest_on_triangle(const Vector3f& p, const Vector3f& a, const Vector3f& b, const Vector3f& c) {
  const Vector3f ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return a;
  const Vector3f bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0f && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return a + ab * (d1 / std::max(d1 - d3, 1e-30f));
  const Vector3f cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0f && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return a + ac * (d2 / std::max(d2 - d6, 1e-30f));
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f)
    return b + (c - b) * ((d4 - d3) / std::max((d4 - d3) + (d5 - d6), 1e-30f));
  const float scale = 1.0f / std::max(va + vb + vc, 1e-30f);
  return a + ab * (vb * scale) + ac * (vc * scale);
}

struct Search {
  const std::vector<Vector3f>* vertices;
  const std::vector<Eigen::Matrix<std::uint32_t, 3, 1>>* triangles;
  Vector3f point;
  Nearest best;
};

bool visit(RTCPointQueryFunctionArguments* found) {
  auto& search = *static_cast<Search*>(found->userPtr);
  const auto& t = (*search.triangles)[found->primID];
  const Vector3f place =
      closest_on_triangle(search.point, (*search.vertices)[t[0]], (*search.vertices)[t[1]], (*search.vertices)[t[2]]);
  const float distance = (place - search.point).norm();
  // The lower number wins a tie, so that the answer does not hang on the order of the visits.
  if (distance > search.best.distance_m || (distance == search.best.distance_m && found->primID > search.best.triangle))
    return false;
  search.best = {distance, place, found->primID};
  found->query->radius = distance;
  return true;
}

}  // namespace

std::optional<Nearest> RayScene::nearest(const Vector3f& point, float radius_m) const {
  Search search{&tree_->vertices, &tree_->triangles, point, {}};
  search.best.distance_m = radius_m;
  search.best.triangle = kNoTriangle;
  RTCPointQuery query{point.x(), point.y(), point.z(), 0.0f, radius_m};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(tree_->scene, &query, &context, visit, &search);
  if (search.best.triangle == kNoTriangle) return std::nullopt;
  return search.best;
}

std::optional<Contact> RayScene::first_contact(const Vector3f& start, const Vector3f& end, float radius_m) const {
  const float length = (end - start).norm();
  const Vector3f direction = length > 0.0f ? Vector3f((end - start) / length) : Vector3f::Zero();
  float gone = 0.0f;
  while (true) {
    const Vector3f centre = start + direction * gone;
    const float left = length - gone;
    const auto near = nearest(centre, radius_m + left + kContactTolerance_m);
    if (!near) return std::nullopt;
    const float free = near->distance_m - radius_m;
    if (free <= kContactTolerance_m) return Contact{length > 0.0f ? gone / length : 0.0f, centre, near->place};
    if (left <= 0.0f) return std::nullopt;
    const float next = std::min(length, gone + free);
    // Beyond some kilometres a step of the tolerance is lost in rounding: then it counts as touched.
    if (!(next > gone)) return Contact{gone / length, centre, near->place};
    gone = next;
  }
}

}  // namespace adit::sim
