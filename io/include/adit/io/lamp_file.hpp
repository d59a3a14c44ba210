// Patterns of lamps (adit/lamp.hpp) as files: what one flight learnt, for the next.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "adit/io/errors.hpp"
#include "adit/lamp.hpp"

namespace adit::io {

/// Reads `lobe`, a list of six numbers, and `frames`.
/// @param name  the file's name, for messages.
/// @throws ConfigError "NAME:LINE: ..." for broken YAML, a missing, unknown or wrong field, or numbers that are no
/// lobe.
[[nodiscard]] LampPattern lamp_of_yaml(std::string_view text, std::string_view name);

/// The same for a file. @throws ConfigError also when the file is missing, empty or unreadable.
[[nodiscard]] LampPattern read_lamp(const std::filesystem::path& path);

/// lamp_of_yaml() of it gives the same pattern.
[[nodiscard]] std::string to_yaml(const LampPattern& pattern);

}  // namespace adit::io
