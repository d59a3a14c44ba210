// Sixteen lanes that are certain to be vector instructions, where the compiler's own choice is not relied on. Included
// only by the files that are compiled per CPU target.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "lanes.hpp"
#include "mesh_tree.hpp"

namespace adit::sim {
namespace {

/// On each target in as many pieces as it takes.
using Floats = float __attribute__((vector_size(4 * kTreeWidth), may_alias));
using Ints = std::int32_t __attribute__((vector_size(4 * kTreeWidth), may_alias));

ADIT_LANE const Floats& floats_at(const float* p) { return *reinterpret_cast<const Floats*>(p); }
ADIT_LANE Floats& floats_at(float* p) { return *reinterpret_cast<Floats*>(p); }
ADIT_LANE Ints& ints_at(std::int32_t* p) { return *reinterpret_cast<Ints*>(p); }
ADIT_LANE Floats all_of(float x) { return x - Floats{}; }
ADIT_LANE Floats lesser(const Floats& a, const Floats& b) { return a < b ? a : b; }
ADIT_LANE Floats greater(const Floats& a, const Floats& b) { return a > b ? a : b; }
ADIT_LANE Ints truncated(const Floats& x) { return __builtin_convertvector(x, Ints); }

/// One bit a lane of flags that are 0 or -1.
ADIT_LANE std::uint32_t bits_of(const Ints& flags) {
#if defined(__AVX512DQ__)
  return _mm512_movepi32_mask(reinterpret_cast<const __m512i&>(flags));
#elif defined(__AVX2__)
  const auto* const halves = reinterpret_cast<const __m256*>(&flags);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(halves[0])) |
         static_cast<std::uint32_t>(_mm256_movemask_ps(halves[1])) << 8;
#else
  std::uint32_t bits = 0;
  for (int j = 0; j < kTreeWidth; ++j) bits |= (static_cast<std::uint32_t>(flags[j]) >> 31) << j;
  return bits;
#endif
}

/// From memory that need not be aligned.
template <class Lanes, class Number>
ADIT_LANE Lanes lanes_from(const Number* p) {
  Lanes lanes;
  std::memcpy(&lanes, p, sizeof lanes);
  return lanes;
}

}  // namespace
}  // namespace adit::sim
