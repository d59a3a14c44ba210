// A course that is built in a moment: 8 m straight on, then a bend.
#pragma once

#include "adit/sim/course.hpp"

namespace adit::sim {

inline CourseConfig short_drift() {
  CourseConfig config;
  config.name = "short_drift";
  config.run_out_m = 4.0;
  config.cell_m = 0.2;
  PassagePlan plan;
  plan.to = "goal";
  plan.end = NodeKind::kGoal;
  plan.moves = {{.straight_m = 8.0}, {.turn_deg = 60.0, .radius_m = 8.0}};
  config.passages = {plan};
  return config;
}

}  // namespace adit::sim
