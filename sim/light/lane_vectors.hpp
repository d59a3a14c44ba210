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
ADIT_LANE Floats lesser(const Floats& a, const Floats& b) {
#if defined(__AVX512F__)
  return _mm512_maskz_min_ps(0xffff, a, b);
#else
  return a < b ? a : b;
#endif
}
ADIT_LANE Floats greater(const Floats& a, const Floats& b) {
#if defined(__AVX512F__)
  return _mm512_maskz_max_ps(0xffff, a, b);
#else
  return a > b ? a : b;
#endif
}
ADIT_LANE Floats root_of(const Floats& x) {
#if defined(__AVX512F__)
  return _mm512_maskz_sqrt_ps(0xffff, x);
#else
  Floats root;
  auto* const to = reinterpret_cast<float*>(&root);
  const auto* const from = reinterpret_cast<const float*>(&x);
  _Pragma("GCC ivdep") for (int j = 0; j < kTreeWidth; ++j) to[j] = std::sqrt(from[j]);
  return root;
#endif
}
ADIT_LANE Ints truncated(const Floats& x) { return __builtin_convertvector(x, Ints); }

ADIT_LANE Ints lane_numbers() { return Ints{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}; }

/// As exp2_lane and its like, to the bit.
ADIT_LANE Floats exp2_lanes(const Floats& any) {
  const Floats x = lesser(greater(any, all_of(-120.0f)), all_of(120.0f));
  const Floats shifted = x + 0.5f;
  Ints i = truncated(shifted);
  i += shifted < __builtin_convertvector(i, Floats);
  const Floats f = x - __builtin_convertvector(i, Floats);
  const Ints power = (i + 127) << 23;
  return exp2_series(f) * reinterpret_cast<const Floats&>(power);
}
ADIT_LANE Floats exp_lanes(const Floats& x) { return exp2_lanes(x * 1.44269504f); }
ADIT_LANE Floats log2_lanes(const Floats& x) {
  const Ints b = reinterpret_cast<const Ints&>(x);
  const Ints e = (b - 0x3f3504f3) >> 23;
  const Ints mantissa = b - (e << 23);
  const Floats& m = reinterpret_cast<const Floats&>(mantissa);
  return log2_series(m) + __builtin_convertvector(e, Floats);
}

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

/// One lane, from memory: what is asked by a number that varies must not be kept in registers.
ADIT_LANE float lane_of(const Floats& x, int j) { return reinterpret_cast<const float*>(&x)[j]; }
ADIT_LANE std::int32_t lane_of(const Ints& x, int j) { return reinterpret_cast<const std::int32_t*>(&x)[j]; }

/// From memory that need not be aligned.
template <class Lanes, class Number>
ADIT_LANE Lanes lanes_from(const Number* p) {
  Lanes lanes;
  std::memcpy(&lanes, p, sizeof lanes);
  return lanes;
}

/// Four runs of four floats, `stride` apart.
ADIT_LANE Floats runs_from(const float* p, int stride) {
#if defined(__AVX512F__)
  // Not by way of memory: sixteen lanes cannot be read back at once from four stores.
  __m512 lanes = _mm512_castps128_ps512(_mm_loadu_ps(p));
  lanes = _mm512_insertf32x4(lanes, _mm_loadu_ps(p + stride), 1);
  lanes = _mm512_insertf32x4(lanes, _mm_loadu_ps(p + 2 * stride), 2);
  return _mm512_insertf32x4(lanes, _mm_loadu_ps(p + 3 * stride), 3);
#else
  float runs[kTreeWidth];
  for (int k = 0; k < 4; ++k) std::memcpy(runs + 4 * k, p + k * stride, 4 * sizeof(float));
  return lanes_from<Floats>(runs);
#endif
}

/// table[at] and table[at + 1] of each lane. Read as pairs they cost half of what two gathers do.
struct FloatPairs {
  Floats first, second;
};
ADIT_LANE FloatPairs pairs_from(const float* table, const Ints& at) {
  FloatPairs pairs;
#if defined(__AVX512F__)
  const auto* const halves = reinterpret_cast<const __m256i*>(&at);
  // Masked, as GCC 12 takes the plain one's unused source for a fault.
  const __m512d none = _mm512_setzero_pd();
  const __m512 low = _mm512_castpd_ps(_mm512_mask_i32gather_pd(none, 0xff, halves[0], table, 4));
  const __m512 high = _mm512_castpd_ps(_mm512_mask_i32gather_pd(none, 0xff, halves[1], table, 4));
  const __m512i even = _mm512_set_epi32(30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0);
  pairs.first = _mm512_permutex2var_ps(low, even, high);
  pairs.second = _mm512_permutex2var_ps(low, _mm512_or_si512(even, _mm512_set1_epi32(1)), high);
#else
  auto* const first = reinterpret_cast<float*>(&pairs.first);
  auto* const second = reinterpret_cast<float*>(&pairs.second);
  const auto* const place = reinterpret_cast<const std::int32_t*>(&at);
  for (int j = 0; j < kTreeWidth; ++j) {
    first[j] = table[place[j]];
    second[j] = table[place[j] + 1];
  }
#endif
  return pairs;
}

}  // namespace
}  // namespace adit::sim
