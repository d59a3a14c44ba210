// A flat element as a sum of small ones (Minkowski): the best value over the sum is the best over one of them, taken
// over the next. Internal to the morphology.
#pragma once

#include <vector>

#include "adit/morphology.hpp"

namespace adit {

/// element = core + {0, pairs[0]} + {0, pairs[1]} + ..., exactly. A disc of 101 rows is 40 pairs and a core of 3 rows,
/// where its rectangles are 31 and its rows 101.
struct ElementSum {
  /// A second place beside the first: dv rows below and du columns to the right, px. dv >= 0; du > 0 where dv == 0.
  struct Pair {
    int du;
    int dv;
  };
  /// Columns left to right of row v, about the element's anchor, px.
  struct Chord {
    int v;
    int left;
    int right;
  };

  std::vector<Chord> core;  ///< from the top to the bottom
  std::vector<Pair> pairs;  ///< the widest first
};

/// May throw std::bad_alloc.
[[nodiscard]] ElementSum sum_of(const StructuringElement& element);

}  // namespace adit
