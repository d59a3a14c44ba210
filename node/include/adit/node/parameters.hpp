// Parameters as parameter servers hold them. C++17, as are all headers that ROS's own have to live beside: messages
// that Debian's generator made do not compile as C++20.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace adit::node {

/// Enumerations are strings.
using ParameterValue = std::variant<bool, int, double, std::string>;

/// One parameter: its name is the field's, without the section; no two fields of a node share one.
struct Parameter {
  std::string section;
  std::string name;
  ParameterValue value;
  std::string unit;  ///< "" for unitless
  double minimum = 0.0;
  double maximum = 0.0;
  bool is_odd = false;  ///< a size about a middle pixel
  std::string meaning;
  std::string source;
  std::vector<std::string> choices;  ///< of an enumeration
};

}  // namespace adit::node
