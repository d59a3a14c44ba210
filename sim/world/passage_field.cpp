#include "passage_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::sim {
namespace {

/// Fillet between wall and floor, where muck lies.
constexpr float kFloorFillet_m = 0.3f;
/// Walls run into each other smoothly from this height on, wholly so at twice of it: two floors at one height must not
/// dig a pit where they overlap.
constexpr float kBlendFoot_m = 0.5f;
/// The passage goes on behind the plane of a mouth by this much, so that the plane cuts it clean.
constexpr float kMouthOverrun_m = 1.5f;
/// The rock face over a mouth leans back by this much per metre of height.
constexpr float kFaceLean = 0.25f;
/// How far the distance may change per metre; more than 1 because slopes and ends are not exact.
constexpr float kLipschitz = 1.3f;

float smooth_min(float a, float b, float k) noexcept {
  const float h = std::max(k - std::abs(a - b), 0.0f);
  return k > 0.0f ? std::min(a, b) - h * h / (4.0f * k) : std::min(a, b);
}
float smooth_max(float a, float b, float k) noexcept { return -smooth_min(-a, -b, k); }

Eigen::Vector2f flat(const Eigen::Vector3f& p) { return {p.x(), p.y()}; }

Stretch stretch_between(const AxisPoint& a, const AxisPoint& b, int passage) {
  Stretch s;
  s.from = flat(a.place);
  const Eigen::Vector2f way = flat(b.place) - s.from;
  s.length = way.norm();
  s.direction = s.length > 1e-6f ? Eigen::Vector2f(way / s.length) : Eigen::Vector2f::UnitX();
  const float per_metre = s.length > 1e-6f ? 1.0f / s.length : 0.0f;
  s.floor = a.place.z();
  s.grade = (b.place.z() - a.place.z()) * per_metre;
  s.half_width = 0.5f * a.width_m;
  s.half_widening = 0.5f * (b.width_m - a.width_m) * per_metre;
  s.height = a.height_m;
  s.heightening = (b.height_m - a.height_m) * per_metre;
  s.passage = passage;
  return s;
}

/// The axis made longer at a mouth.
AxisPoint beyond(const AxisPoint& end, const AxisPoint& before) {
  AxisPoint point = end;
  Eigen::Vector3f way = end.place - before.place;
  way.z() = 0.0f;
  point.place += way.normalized() * kMouthOverrun_m;
  return point;
}

/// How far the axis may lie beside a stretch that stands for it, and how long a stretch may be.
constexpr float kStretchTolerance_m = 0.03f;
constexpr float kStretchLength_m = 6.0f;

/// True when the points between `first` and `last` lie on the line between these, width and height too.
bool is_even(const std::vector<AxisPoint>& axis, std::size_t first, std::size_t last) {
  const AxisPoint& a = axis[first];
  const AxisPoint& b = axis[last];
  const float length = (b.place - a.place).norm();
  if (length > kStretchLength_m) return false;
  for (std::size_t i = first + 1; i < last; ++i) {
    const float share = (axis[i].place - a.place).norm() / length;
    const float off = (a.place + share * (b.place - a.place) - axis[i].place).norm() +
                      std::abs(std::lerp(a.width_m, b.width_m, share) - axis[i].width_m) +
                      std::abs(std::lerp(a.height_m, b.height_m, share) - axis[i].height_m);
    if (off > kStretchTolerance_m) return false;
  }
  return true;
}

}  // namespace

PassageField::PassageField(const Layout& layout, float crown_fraction, float blend_m, float apron_m)
    : mouths_(layout.mouths), crown_fraction_(crown_fraction), blend_m_(blend_m), apron_m_(apron_m) {
  int index = 0;
  for (const Passage& passage : layout.passages) add_passage(passage, index++, layout.nodes);
  for (const Room& room : layout.rooms) {
    const AxisPoint point{room.place, room.width_m, room.height_m};
    stretches_.push_back(stretch_between(point, point, index++));
  }
}

void PassageField::add_passage(const Passage& passage, int index, const std::vector<Node>& nodes) {
  std::vector<AxisPoint> axis = passage.axis;
  const NodeKind first = nodes[static_cast<std::size_t>(passage.from)].kind;
  const NodeKind last = nodes[static_cast<std::size_t>(passage.to)].kind;
  if (first == NodeKind::kMouth) axis.insert(axis.begin(), beyond(axis[0], axis[1]));
  if (last == NodeKind::kMouth) axis.push_back(beyond(axis.back(), axis[axis.size() - 2]));
  const std::size_t begin = stretches_.size();
  for (std::size_t i = 0; i + 1 < axis.size();) {
    std::size_t to = i + 1;
    while (to + 1 < axis.size() && is_even(axis, i, to + 1)) ++to;
    stretches_.push_back(stretch_between(axis[i], axis[to], index));
    i = to;
  }
  if (first == NodeKind::kDeadEnd) stretches_[begin].flat_start = true;
  if (last == NodeKind::kDeadEnd) stretches_.back().flat_end = true;
}

float PassageField::distance_to(const Stretch& s, const Eigen::Vector3f& p, float& above_floor) const noexcept {
  const Eigen::Vector2f way = flat(p) - s.from;
  const float along = way.dot(s.direction);
  const float t = std::clamp(along, 0.0f, s.length);
  const bool past_face = (s.flat_start && along < 0.0f) || (s.flat_end && along > s.length);
  const float aside =
      past_face ? std::abs(way.x() * s.direction.y() - way.y() * s.direction.x()) : (way - s.direction * t).norm();
  const float half_width = s.half_width + s.half_widening * t;
  const float height = s.height + s.heightening * t;
  above_floor = p.z() - (s.floor + s.grade * t);
  const float corner = crown_fraction_ * std::min(half_width, height);
  const float qx = aside - (half_width - corner);
  const float qz = above_floor - (height - corner);
  const float out_x = std::max(qx, 0.0f);
  const float out_z = std::max(qz, 0.0f);
  const float outside = std::sqrt(out_x * out_x + out_z * out_z);
  float distance = std::min(std::max(qx, qz), 0.0f) + outside - corner;
  if (s.flat_start) distance = smooth_max(distance, -along, kFloorFillet_m);
  if (s.flat_end) distance = smooth_max(distance, along - s.length, kFloorFillet_m);
  return smooth_max(distance, -above_floor, kFloorFillet_m);
}

float PassageField::distance_to_open_air(const Mouth& mouth, const Eigen::Vector3f& p) const noexcept {
  const float above_floor = p.z() - mouth.place.z();
  const float into_rock = -(flat(p) - flat(mouth.place)).dot(mouth.outward);
  return smooth_max(into_rock - kFaceLean * above_floor, -above_floor, kFloorFillet_m);
}

float PassageField::blend_over(float above_floor) const noexcept {
  return blend_m_ * std::clamp((above_floor - kBlendFoot_m) / kBlendFoot_m, 0.0f, 1.0f);
}

OpenDistance PassageField::at(const Eigen::Vector3f& p, const Candidates& candidates) const noexcept {
  constexpr float kFar = 1e6f;
  OpenDistance result{kFar, 0.0f};
  float nearest = kFar;
  float of_passage = kFar;
  int passage = -1;
  for (const std::uint32_t index : candidates) {
    const Stretch& stretch = stretches_[index];
    if (stretch.passage != passage) {
      result.distance = smooth_min(result.distance, of_passage, blend_over(result.above_floor));
      of_passage = kFar;
      passage = stretch.passage;
    }
    float above_floor = 0.0f;
    const float distance = distance_to(stretch, p, above_floor);
    of_passage = std::min(of_passage, distance);
    if (distance < nearest) {
      nearest = distance;
      result.above_floor = above_floor;
    }
  }
  result.distance = smooth_min(result.distance, of_passage, blend_over(result.above_floor));
  for (const Mouth& mouth : mouths_) {
    if (!mouth.has_apron) continue;
    const float air = distance_to_open_air(mouth, p);
    if (air < nearest) {
      nearest = air;
      result.above_floor = p.z() - mouth.place.z();
    }
    result.distance = smooth_min(result.distance, air, blend_over(result.above_floor));
  }
  return result;
}

void PassageField::cull(const Eigen::Vector3f& p, float radius, Candidates& candidates) const {
  float above_floor = 0.0f;
  float nearest = std::numeric_limits<float>::max();
  std::vector<float> distances;
  distances.reserve(candidates.size());
  for (const std::uint32_t index : candidates) {
    distances.push_back(distance_to(stretches_[index], p, above_floor));
    nearest = std::min(nearest, distances.back());
  }
  const float limit = nearest + 2.0f * kLipschitz * radius + blend_m_ + 1e-3f;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (distances[i] <= limit) candidates[kept++] = candidates[i];
  candidates.resize(kept);
}

PassageField::Candidates PassageField::all() const {
  Candidates candidates(stretches_.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i] = static_cast<std::uint32_t>(i);
  return candidates;
}

void PassageField::box_of(const Stretch& s, float margin, Eigen::Vector3f& low, Eigen::Vector3f& high) const {
  const Eigen::Vector2f to = s.from + s.direction * s.length;
  const float wide = std::max(s.half_width, s.half_width + s.half_widening * s.length) + margin;
  const float floor_to = s.floor + s.grade * s.length;
  const float top = std::max(s.floor + s.height, floor_to + s.height + s.heightening * s.length);
  low << std::min(s.from.x(), to.x()) - wide, std::min(s.from.y(), to.y()) - wide, std::min(s.floor, floor_to) - margin;
  high << std::max(s.from.x(), to.x()) + wide, std::max(s.from.y(), to.y()) + wide, top + margin;
}

bool PassageField::is_outside(const Eigen::Vector3f& p) const noexcept {
  for (const Mouth& mouth : mouths_) {
    const Eigen::Vector2f way = flat(p) - flat(mouth.place);
    const float out = way.dot(mouth.outward);
    if (mouth.has_apron) continue;
    const float height = p.z() - mouth.place.z();
    // The rock round the opening, and no other passage that may lie behind it.
    if (out > 0.0f && out < kMouthOverrun_m + mouth.width_m + 1.5f &&
        (way - mouth.outward * out).norm() < 0.5f * mouth.width_m + 1.5f && height > -1.5f &&
        height < mouth.height_m + 1.5f)
      return true;
  }
  return false;
}

}  // namespace adit::sim
