#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "image_bytes.hpp"

namespace adit::io {
namespace {

constexpr std::array<unsigned char, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kFrameBytes = 12;  ///< of a chunk beside its content: length, type, checksum

std::uint32_t big_endian(const unsigned char* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) | std::uint32_t{p[3]};
}

/// ISO 3309, as the PNG specification's annex D has it.
std::uint32_t crc32(const unsigned char* p, std::size_t length) {
  static const auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1u) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      table[n] = c;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < length; ++i) crc = kTable[(crc ^ p[i]) & 0xffu] ^ (crc >> 8);
  return ~crc;
}

bool is_needed(std::string_view type) { return type == "IHDR" || type == "PLTE" || type == "IDAT" || type == "IEND"; }

}  // namespace

bool is_png(const Bytes& bytes) {
  return bytes.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

std::string check_png(const Bytes& bytes, Bytes& plain) {
  plain.assign(kSignature.begin(), kSignature.end());
  plain.reserve(bytes.size());
  std::size_t at = kSignature.size();
  while (bytes.size() - at >= kFrameBytes) {
    const unsigned char* chunk = bytes.data() + at;
    const std::size_t length = big_endian(chunk);
    if (length > bytes.size() - at - kFrameBytes) break;
    const std::string_view type(reinterpret_cast<const char*>(chunk) + 4, 4);
    if (is_needed(type)) {
      if (crc32(chunk + 4, length + 4) != big_endian(chunk + 8 + length)) {
        return "the PNG is damaged: wrong checksum at byte " + std::to_string(at);
      }
      plain.insert(plain.end(), chunk, chunk + length + kFrameBytes);
    }
    if (type == "IEND") return "";
    at += length + kFrameBytes;
  }
  return "the file is truncated: the PNG ends early";
}

}  // namespace adit::io
