// What can be known of a mesh file before Assimp, which trusts what files say of themselves, is let loose on it.
#pragma once

#include <cstdint>
#include <string>

namespace adit::sim {

/// Of a path, in lower case, with its dot.
[[nodiscard]] std::string extension_of(const std::string& path);

/// @throws WorldError "PATH: WHY"
[[noreturn]] void refuse(const std::string& path, const std::string& why);
void refuse_if_too_many(const std::string& path, std::uint64_t triangles);

/// That the file is there, is of a known format, not too large, and whole as far as its head tells.
/// @throws WorldError
void check_mesh_file(const std::string& path);

}  // namespace adit::sim
