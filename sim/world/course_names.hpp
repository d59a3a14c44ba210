// Names of the enumerations in course files.
#pragma once

#include <array>
#include <string_view>

#include "adit/sim/course.hpp"

namespace adit::sim {

template <class Enum>
struct NamesOf;

template <>
struct NamesOf<LayoutKind> {
  static constexpr std::array<std::string_view, 4> names{"moves", "random_tunnel", "random_network", "tiles"};
};

template <>
struct NamesOf<NodeKind> {
  static constexpr std::array<std::string_view, 5> names{"mouth", "bend", "junction", "dead_end", "goal"};
};

}  // namespace adit::sim
