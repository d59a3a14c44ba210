// What the readers of YAML files share: places in messages, and names that are nearly right.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <string_view>
#include <vector>

#include "adit/io/errors.hpp"

namespace adit::io {

/// "NAME:LINE", or NAME where the line is not known.
[[nodiscard]] std::string place_of(std::string_view name, const YAML::Mark& mark);

/// The document's root, a map. @throws ConfigError "NAME:LINE: ..." when it is broken or no map.
/// An empty document (comments only) gives a null node.
[[nodiscard]] YAML::Node load_yaml(std::string_view text, std::string_view name);

/// Text to show in a message: shortened, control characters replaced, so that a message stays one line.
[[nodiscard]] std::string on_one_line(std::string_view text, std::size_t longest = 60);
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "; did you mean 'omega'?" or, when nothing is near, "; known are: a, b, c".
[[nodiscard]] std::string hint_for(std::string_view name, const std::vector<std::string>& known);

/// The whole of `text` as a finite number, in any locale; false when it is none.
[[nodiscard]] bool parse_number(std::string_view text, double& value);
[[nodiscard]] bool parse_number(std::string_view text, int& value);

/// A number as a person writes it: shortest digits that read back the same.
[[nodiscard]] std::string shortest(double value);

}  // namespace adit::io
