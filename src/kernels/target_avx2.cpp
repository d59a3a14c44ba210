// CPU target `avx2`: 32 bytes at a time.
#include <immintrin.h>

#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 32;
  __m256i v;
};

inline Bytes load(const std::uint8_t* p) { return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))}; }
inline void store(std::uint8_t* p, Bytes a) { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), a.v); }
inline Bytes fill(std::uint8_t value) { return {_mm256_set1_epi8(static_cast<char>(value))}; }
inline Bytes smallest(Bytes a, Bytes b) { return {_mm256_min_epu8(a.v, b.v)}; }
inline Bytes largest(Bytes a, Bytes b) { return {_mm256_max_epu8(a.v, b.v)}; }
inline Bytes at_most(Bytes a, Bytes limit) { return {_mm256_cmpeq_epi8(_mm256_min_epu8(a.v, limit.v), a.v)}; }
inline Bytes minus(Bytes a, Bytes b) { return {_mm256_sub_epi8(a.v, b.v)}; }
inline bool any_above(Bytes a, Bytes b) { return _mm256_movemask_epi8(_mm256_cmpeq_epi8(largest(a, b).v, b.v)) != -1; }
inline std::uint32_t sum(Bytes a) {
  const __m256i parts = _mm256_sad_epu8(a.v, _mm256_setzero_si256());
  return static_cast<std::uint32_t>(_mm256_extract_epi32(parts, 0) + _mm256_extract_epi32(parts, 2) +
                                    _mm256_extract_epi32(parts, 4) + _mm256_extract_epi32(parts, 6));
}

inline int least_of_16(__m128i a) {
  const __m128i pairs = _mm_min_epu8(a, _mm_srli_epi16(a, 8));
  return _mm_cvtsi128_si32(_mm_minpos_epu16(_mm_and_si128(pairs, _mm_set1_epi16(255)))) & 255;
}
inline int most_of_16(__m128i a) { return 255 - least_of_16(_mm_xor_si128(a, _mm_set1_epi8(-1))); }
inline int least(Bytes a) {
  return least_of_16(_mm_min_epu8(_mm256_castsi256_si128(a.v), _mm256_extracti128_si256(a.v, 1)));
}
inline int most(Bytes a) {
  return most_of_16(_mm_max_epu8(_mm256_castsi256_si128(a.v), _mm256_extracti128_si256(a.v, 1)));
}

// For counting levels in bits.
inline Bytes plus(Bytes a, Bytes b) { return {_mm256_add_epi8(a.v, b.v)}; }
inline Bytes plus_saturated(Bytes a, Bytes b) { return {_mm256_adds_epu8(a.v, b.v)}; }
inline Bytes either(Bytes a, Bytes b) { return {_mm256_or_si256(a.v, b.v)}; }

// Bit i of a byte for the indices 8 + i, as long as the top bit is clear.
inline Bytes picked(Bytes index) {
  const __m256i bits = _mm256_broadcastsi128_si256(_mm_setr_epi8(0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 4, 8, 16, 32, 64, -128));
  return {_mm256_shuffle_epi8(bits, index.v)};
}

// sum + a + b, bit by bit: the low bits stay in `sum`.
inline void add_bits(Bytes& sum, Bytes a, Bytes b, Bytes& carry) {
  const __m256i one_of_two = _mm256_xor_si256(a.v, b.v);
  carry.v = _mm256_or_si256(_mm256_and_si256(a.v, b.v), _mm256_and_si256(sum.v, one_of_two));
  sum.v = _mm256_xor_si256(sum.v, one_of_two);
}

inline std::uint32_t ones_at(Bytes a, int bit) {
  const int set = _mm256_movemask_epi8(_mm256_sll_epi16(a.v, _mm_cvtsi32_si128(7 - bit)));
  return static_cast<std::uint32_t>(__builtin_popcount(static_cast<unsigned>(set)));
}

#include "blocks_sse41.inl"

constexpr int kTripletBlock = 16;
constexpr int kTripletExtra = 2;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) { triplet_minimum_16(p, to); }

#include "level_bits.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kAvx2Loops = kLoops;

}  // namespace adit::kernels
