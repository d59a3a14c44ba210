// What an answer repeats of its best opening.
#pragma once

#include "adit/finder.hpp"

namespace adit {

inline void note_best(Rule rule, OpenSpace& out) noexcept {
  const Opening& best = out.openings[0];
  out.status = Status::kFound;
  out.rule = rule;
  out.confidence = best.confidence;
  out.centroid_px = best.centroid_px;
  out.point = best.point;
  out.bearing = best.bearing;
  out.area_fraction = best.area_fraction;
}

/// Of a place that lit rock encloses.
inline Rule rule_by_rim(const Opening& opening) noexcept {
  return opening.touches_border ? Rule::kOpenSided : Rule::kEnclosed;
}

}  // namespace adit
