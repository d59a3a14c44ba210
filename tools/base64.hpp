// Bytes as text, for pages that hold everything they show.
#pragma once

#include <cstddef>
#include <string>

namespace adit::tools {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64_of(const void* bytes, std::size_t size);

}  // namespace adit::tools
