// CPU target `avx512` (F, BW, VL, DQ): 64 bytes at a time.
#include <immintrin.h>

#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 64;
  __m512i v;
};

inline Bytes load(const std::uint8_t* p) { return {_mm512_loadu_si512(p)}; }
inline void store(std::uint8_t* p, Bytes a) { _mm512_storeu_si512(p, a.v); }
inline Bytes fill(std::uint8_t value) { return {_mm512_set1_epi8(static_cast<char>(value))}; }
inline Bytes smallest(Bytes a, Bytes b) { return {_mm512_min_epu8(a.v, b.v)}; }
inline Bytes largest(Bytes a, Bytes b) { return {_mm512_max_epu8(a.v, b.v)}; }
inline Bytes at_most(Bytes a, Bytes limit) { return {_mm512_movm_epi8(_mm512_cmple_epu8_mask(a.v, limit.v))}; }
inline Bytes minus(Bytes a, Bytes b) { return {_mm512_sub_epi8(a.v, b.v)}; }
inline bool any_above(Bytes a, Bytes b) { return _mm512_cmpgt_epu8_mask(a.v, b.v) != 0; }
inline std::uint32_t sum(Bytes a) {
  return static_cast<std::uint32_t>(_mm512_reduce_add_epi64(_mm512_sad_epu8(a.v, _mm512_setzero_si512())));
}

inline int least_of_16(__m128i a) {
  const __m128i pairs = _mm_min_epu8(a, _mm_srli_epi16(a, 8));
  return _mm_cvtsi128_si32(_mm_minpos_epu16(_mm_and_si128(pairs, _mm_set1_epi16(255)))) & 255;
}
inline int most_of_16(__m128i a) { return 255 - least_of_16(_mm_xor_si128(a, _mm_set1_epi8(-1))); }
inline __m128i quarter(Bytes a, int which) {
  return which == 0   ? _mm512_castsi512_si128(a.v)
         : which == 1 ? _mm512_extracti32x4_epi32(a.v, 1)
         : which == 2 ? _mm512_extracti32x4_epi32(a.v, 2)
                      : _mm512_extracti32x4_epi32(a.v, 3);
}
inline int least(Bytes a) {
  return least_of_16(
      _mm_min_epu8(_mm_min_epu8(quarter(a, 0), quarter(a, 1)), _mm_min_epu8(quarter(a, 2), quarter(a, 3))));
}
inline int most(Bytes a) {
  return most_of_16(
      _mm_max_epu8(_mm_max_epu8(quarter(a, 0), quarter(a, 1)), _mm_max_epu8(quarter(a, 2), quarter(a, 3))));
}

// For counting levels in bits.
inline Bytes plus(Bytes a, Bytes b) { return {_mm512_add_epi8(a.v, b.v)}; }
inline Bytes plus_saturated(Bytes a, Bytes b) { return {_mm512_adds_epu8(a.v, b.v)}; }
inline Bytes either(Bytes a, Bytes b) { return {_mm512_or_si512(a.v, b.v)}; }

// Bit i of a byte for the indices 8 + i, as long as the top bit is clear.
inline Bytes picked(Bytes index) {
  const __m512i bits = _mm512_broadcast_i32x4(_mm_setr_epi8(0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 4, 8, 16, 32, 64, -128));
  return {_mm512_shuffle_epi8(bits, index.v)};
}

// sum + a + b, bit by bit: the low bits stay in `sum`.
inline void add_bits(Bytes& sum, Bytes a, Bytes b, Bytes& carry) {
  carry.v = _mm512_ternarylogic_epi64(sum.v, a.v, b.v, 0xE8);
  sum.v = _mm512_ternarylogic_epi64(sum.v, a.v, b.v, 0x96);
}

inline std::uint32_t ones_at(Bytes a, int bit) {
  const __mmask64 set = _mm512_test_epi8_mask(a.v, _mm512_set1_epi8(static_cast<char>(1 << bit)));
  return static_cast<std::uint32_t>(__builtin_popcountll(set));
}

#include "blocks_sse41.inl"

inline __m512i smallest_of_next_3_wide(const std::uint8_t* p) {
  return _mm512_min_epu8(_mm512_min_epu8(_mm512_loadu_si512(p), _mm512_loadu_si512(p + 1)), _mm512_loadu_si512(p + 2));
}

// 64 pixels of 3 bytes; reads 2 bytes beyond them. As in the 16-pixel block, each output lane of 16 pixels is picked
// from three neighbouring input lanes; these are first brought together: lanes 0 3 6 9, 1 4 7 10 and 2 5 8 11.
constexpr int kTripletBlock = 64;
constexpr int kTripletExtra = 2;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  const __m512i a = smallest_of_next_3_wide(p);        // lanes 0 1 2 3
  const __m512i b = smallest_of_next_3_wide(p + 64);   // lanes 4 5 6 7
  const __m512i c = smallest_of_next_3_wide(p + 128);  // lanes 8 9 10 11
  const __m512i pick_x = _mm512_setr_epi64(0, 1, 6, 7, 12, 13, 0, 0);
  const __m512i pick_y = _mm512_setr_epi64(2, 3, 8, 9, 14, 15, 0, 0);
  const __m512i pick_z = _mm512_setr_epi64(4, 5, 10, 11, 0, 0, 0, 0);
  const __m512i last_x = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 10, 11);
  const __m512i last_y = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 12, 13);
  const __m512i last_z = _mm512_setr_epi64(0, 1, 2, 3, 8, 9, 14, 15);
  const __m512i x = _mm512_permutex2var_epi64(_mm512_permutex2var_epi64(a, pick_x, b), last_x, c);
  const __m512i y = _mm512_permutex2var_epi64(_mm512_permutex2var_epi64(a, pick_y, b), last_y, c);
  const __m512i z = _mm512_permutex2var_epi64(_mm512_permutex2var_epi64(a, pick_z, b), last_z, c);
  const __m512i first =
      _mm512_broadcast_i32x4(_mm_setr_epi8(0, 3, 6, 9, 12, 15, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1));
  const __m512i second =
      _mm512_broadcast_i32x4(_mm_setr_epi8(-1, -1, -1, -1, -1, -1, 2, 5, 8, 11, 14, -1, -1, -1, -1, -1));
  const __m512i third =
      _mm512_broadcast_i32x4(_mm_setr_epi8(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 4, 7, 10, 13));
  const __m512i low = _mm512_or_si512(_mm512_shuffle_epi8(x, first), _mm512_shuffle_epi8(y, second));
  _mm512_storeu_si512(to, _mm512_or_si512(low, _mm512_shuffle_epi8(z, third)));
}

#include "level_bits.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kAvx512Loops = kLoops;

}  // namespace adit::kernels
