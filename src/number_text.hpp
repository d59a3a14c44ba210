// Numbers in error messages: short and the same under every locale.
#pragma once

#include <array>
#include <charconv>
#include <locale>
#include <sstream>
#include <string>

namespace adit {

inline std::string number_text(double value) {
#if !defined(__cpp_lib_to_chars)  // emscripten's library knows no reals there
  std::ostringstream short_text;
  short_text.imbue(std::locale::classic());
  short_text << value;
  return short_text.str();
#else
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
#endif
}

/// "name: 1.5 px is not in [0, 1] px; set a value in this range"
inline std::string range_fault(const std::string& name, double value, double minimum, double maximum,
                               const std::string& unit) {
  const std::string spaced_unit = unit.empty() ? "" : " " + unit;
  return name + ": " + number_text(value) + spaced_unit + " is not in [" + number_text(minimum) + ", " +
         number_text(maximum) + "]" + spaced_unit + "; set a value in this range";
}

}  // namespace adit
