// Numbers in error messages: short and the same under every locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace adit {

inline std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

/// "name: 1.5 px is not in [0, 1] px; set a value in this range"
inline std::string range_fault(const std::string& name, double value, double minimum, double maximum,
                               const std::string& unit) {
  const std::string spaced_unit = unit.empty() ? "" : " " + unit;
  return name + ": " + number_text(value) + spaced_unit + " is not in [" + number_text(minimum) + ", " +
         number_text(maximum) + "]" + spaced_unit + "; set a value in this range";
}

}  // namespace adit
