// A number in a line of a table.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace adit::tools {

/// Appends ",value" with so many digits, or "," where there is none.
inline void add_cell(std::string& line, double value, int digits) {
  line += ',';
  if (!std::isfinite(value)) return;
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  line += text;
}

}  // namespace adit::tools
