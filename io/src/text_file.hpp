// Whole files as text or bytes, with reasons when that fails.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace adit::io {

/// What fault_of_file() says of a file of no bytes.
inline constexpr const char* kEmptyFile = "the file is empty";

/// Why a path cannot be opened as a file, for a person: "no such file", "is a folder", ...; empty when it can.
[[nodiscard]] std::string fault_of_file(const std::filesystem::path& path);

/// All bytes of a file. @throws InputError "PATH: why" when it is missing, a folder, empty or unreadable.
[[nodiscard]] std::vector<unsigned char> read_bytes(const std::filesystem::path& path);

/// The text of a file of settings. @throws ConfigError as above, and for files above 1 MB, which are none.
[[nodiscard]] std::string read_settings_text(const std::filesystem::path& path);

}  // namespace adit::io
