// The fields of a NavigatorConfig by name, for callers that have no C++ structs: "omega", "finder.omega".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adit/navigator.hpp"

namespace adit::c_interface {

/// Sets a field. @throws std::invalid_argument naming the field, the value and what is allowed; nothing has changed.
void set_field(NavigatorConfig& config, std::string_view field, std::string_view value);
void set_field(NavigatorConfig& config, std::string_view field, double value);
/// @throws std::invalid_argument
[[nodiscard]] std::string field_text(const NavigatorConfig& config, std::string_view field);
/// "finder.method", ... in the order of the structs.
[[nodiscard]] std::vector<std::string> field_names();

}  // namespace adit::c_interface
