// Which blind ends of a network lead out, and where the goals before them lie.
#pragma once

#include <vector>

#include "layout.hpp"

namespace adit::sim {

/// A mouth at the end of a passage, looking away from the point before it.
[[nodiscard]] Mouth mouth_at(const AxisPoint& end, const AxisPoint& inner, bool has_apron);

/// Way along the axes from a node to each node, m; infinity where none leads.
[[nodiscard]] std::vector<double> ways_from(const Layout& layout, int node);

/// Passages whose last node is a mouth get a goal and a mouth where the way from the entrance to that goal is at least
/// goal_min_m; the others become dead ends. Where none is that far, the blind end that is furthest leads out.
/// @param layout  passages that end blind have their blind node last; the entrance is the first node of its passage.
void lead_out(Layout& layout, int entrance, double goal_min_m);

}  // namespace adit::sim
