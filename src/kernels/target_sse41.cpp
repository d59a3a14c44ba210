// CPU target `sse41`: 16 bytes at a time.
#include <smmintrin.h>

#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 16;
  __m128i v;
};

inline Bytes load(const std::uint8_t* p) { return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))}; }
inline void store(std::uint8_t* p, Bytes a) { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), a.v); }
inline Bytes fill(std::uint8_t value) { return {_mm_set1_epi8(static_cast<char>(value))}; }
inline Bytes smallest(Bytes a, Bytes b) { return {_mm_min_epu8(a.v, b.v)}; }
inline Bytes largest(Bytes a, Bytes b) { return {_mm_max_epu8(a.v, b.v)}; }
inline Bytes at_most(Bytes a, Bytes limit) { return {_mm_cmpeq_epi8(_mm_min_epu8(a.v, limit.v), a.v)}; }
inline Bytes minus(Bytes a, Bytes b) { return {_mm_sub_epi8(a.v, b.v)}; }
inline bool any_above(Bytes a, Bytes b) { return _mm_movemask_epi8(_mm_cmpeq_epi8(largest(a, b).v, b.v)) != 0xFFFF; }
inline std::uint32_t sum(Bytes a) {
  const __m128i halves = _mm_sad_epu8(a.v, _mm_setzero_si128());
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(halves) + _mm_extract_epi32(halves, 2));
}

inline int least_of_16(__m128i a) {
  const __m128i pairs = _mm_min_epu8(a, _mm_srli_epi16(a, 8));
  return _mm_cvtsi128_si32(_mm_minpos_epu16(_mm_and_si128(pairs, _mm_set1_epi16(255)))) & 255;
}
inline int most_of_16(__m128i a) { return 255 - least_of_16(_mm_xor_si128(a, _mm_set1_epi8(-1))); }
inline int least(Bytes a) { return least_of_16(a.v); }
inline int most(Bytes a) { return most_of_16(a.v); }

// 16 columns of one row.
inline Bytes load_16_wide(const std::uint8_t* p, std::ptrdiff_t) { return load(p); }

// How often `level` stands in a tile of 256 bytes.
inline std::uint32_t occurrences(const Bytes* tile, std::uint8_t level) {
  const __m128i wanted = _mm_set1_epi8(static_cast<char>(level));
  __m128i count = _mm_setzero_si128();
  for (int i = 0; i < 16; ++i) count = _mm_sub_epi8(count, _mm_cmpeq_epi8(tile[i].v, wanted));
  return sum({count});
}

#include "blocks_sse41.inl"

constexpr int kTripletBlock = 16;
constexpr int kTripletExtra = 2;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) { triplet_minimum_16(p, to); }

#include "level_tiles.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kSse41Loops = kLoops;

}  // namespace adit::kernels
