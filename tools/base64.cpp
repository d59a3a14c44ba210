#include "base64.hpp"

namespace adit::tools {

std::string base64_of(const void* bytes, std::size_t size) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* const byte = static_cast<const unsigned char*>(bytes);
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3) {
    unsigned triple = 0;
    for (std::size_t k = 0; k < 3; ++k) triple = triple << 8 | (i + k < size ? byte[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > size ? '=' : kDigits[triple >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace adit::tools
