// The check that all configurations share: every number inside the range its field note gives.
#pragma once

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>

#include "adit/fields.hpp"

namespace adit::sim {

/// A number as a person reads it.
inline std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// "height_m: 99 is not in 0.1 to 20 m" of the first field that is out of its range.
template <class Config>
std::optional<std::string> first_fault(const Config& config) {
  std::optional<std::string> fault;
  visit_fields(config, [&fault](const FieldNote& note, const auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member>) {
      const double value = static_cast<double>(member);
      if (fault || (value >= note.minimum && value <= note.maximum)) return;
      std::string& text = fault.emplace(note.name);
      text.append(": ").append(shown(value)).append(" is not in ").append(shown(note.minimum));
      text.append(" to ").append(shown(note.maximum));
      if (note.unit[0] != '\0') text.append(" ").append(note.unit);
    }
  });
  return fault;
}

}  // namespace adit::sim
