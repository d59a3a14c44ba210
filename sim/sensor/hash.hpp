// A counter-based generator: the number drawn depends on the counter alone, not on who drew before.
#pragma once

#include <cstdint>

namespace adit::sim {

/// 32 well mixed bits of a counter (finaliser of MurmurHash3).
[[nodiscard]] inline std::uint32_t hashed(std::uint64_t x) noexcept {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace adit::sim
