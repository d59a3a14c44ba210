// CPU target `wasm` (WebAssembly's 128-bit vectors): 16 bytes at a time.
#include <wasm_simd128.h>

#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 16;
  v128_t v;
};

inline Bytes load(const std::uint8_t* p) { return {wasm_v128_load(p)}; }
inline void store(std::uint8_t* p, Bytes a) { wasm_v128_store(p, a.v); }
inline Bytes fill(std::uint8_t value) { return {wasm_u8x16_splat(value)}; }
inline Bytes smallest(Bytes a, Bytes b) { return {wasm_u8x16_min(a.v, b.v)}; }
inline Bytes largest(Bytes a, Bytes b) { return {wasm_u8x16_max(a.v, b.v)}; }
inline Bytes at_most(Bytes a, Bytes limit) { return {wasm_u8x16_le(a.v, limit.v)}; }
inline Bytes minus(Bytes a, Bytes b) { return {wasm_i8x16_sub(a.v, b.v)}; }
inline bool any_above(Bytes a, Bytes b) { return wasm_v128_any_true(wasm_u8x16_gt(a.v, b.v)); }

// Pairs, then fours: four sums of 32 bits.
inline std::uint32_t sum(Bytes a) {
  const v128_t fours = wasm_u32x4_extadd_pairwise_u16x8(wasm_u16x8_extadd_pairwise_u8x16(a.v));
  return static_cast<std::uint32_t>(wasm_i32x4_extract_lane(fours, 0)) +
         static_cast<std::uint32_t>(wasm_i32x4_extract_lane(fours, 1)) +
         static_cast<std::uint32_t>(wasm_i32x4_extract_lane(fours, 2)) +
         static_cast<std::uint32_t>(wasm_i32x4_extract_lane(fours, 3));
}

inline int least(Bytes a) {
  v128_t m = wasm_u8x16_min(a.v, wasm_i8x16_shuffle(a.v, a.v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
  m = wasm_u8x16_min(m, wasm_i8x16_shuffle(m, m, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3));
  m = wasm_u8x16_min(m, wasm_i8x16_shuffle(m, m, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1));
  m = wasm_u8x16_min(m, wasm_i8x16_shuffle(m, m, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0));
  return wasm_u8x16_extract_lane(m, 0);
}
inline int most(Bytes a) { return 255 - least({wasm_v128_not(a.v)}); }

// 16 columns of one row.
inline Bytes load_16_wide(const std::uint8_t* p, std::ptrdiff_t) { return load(p); }

// How often `level` stands in a tile of 256 bytes.
inline std::uint32_t occurrences(const Bytes* tile, std::uint8_t level) {
  const v128_t wanted = wasm_u8x16_splat(level);
  v128_t count = wasm_i8x16_splat(0);
  for (int i = 0; i < 16; ++i) count = wasm_i8x16_sub(count, wasm_i8x16_eq(tile[i].v, wanted));
  return sum({count});
}

// The smaller of the first channels of 16 pixels, which stand three or four bytes apart.
struct Triplets {
  v128_t a, b, c;
};

/// First, second and third byte of 16 triplets, each in a vector of its own.
inline Triplets triplets_of(const std::uint8_t* p) {
  const v128_t x = wasm_v128_load(p), y = wasm_v128_load(p + 16), z = wasm_v128_load(p + 32);
  const v128_t a = wasm_i8x16_shuffle(x, y, 0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 0, 0, 0, 0, 0);
  const v128_t b = wasm_i8x16_shuffle(x, y, 1, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 0, 0, 0, 0, 0);
  const v128_t c = wasm_i8x16_shuffle(x, y, 2, 5, 8, 11, 14, 17, 20, 23, 26, 29, 0, 0, 0, 0, 0, 0);
  return {wasm_i8x16_shuffle(a, z, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17, 20, 23, 26, 29),
          wasm_i8x16_shuffle(b, z, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 18, 21, 24, 27, 30),
          wasm_i8x16_shuffle(c, z, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 19, 22, 25, 28, 31)};
}

constexpr int kTripletBlock = 16;
constexpr int kTripletExtra = 0;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  const Triplets t = triplets_of(p);
  wasm_v128_store(to, wasm_u8x16_min(wasm_u8x16_min(t.a, t.b), t.c));
}

inline void quad_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  // The fourth byte of each pixel is made no smaller than any, then the pairs are compared, and the pairs of pairs.
  const v128_t ignored = wasm_u32x4_splat(0xFF000000u);
  v128_t fours[4];
  for (int i = 0; i < 4; ++i) {
    const v128_t pixels = wasm_v128_or(wasm_v128_load(p + 16 * i), ignored);
    const v128_t pairs = wasm_u8x16_min(pixels, wasm_u16x8_shr(pixels, 8));
    fours[i] = wasm_u8x16_min(pairs, wasm_u32x4_shr(pairs, 16));
  }
  const v128_t low = wasm_i8x16_shuffle(fours[0], fours[1], 0, 4, 8, 12, 16, 20, 24, 28, 0, 0, 0, 0, 0, 0, 0, 0);
  const v128_t high = wasm_i8x16_shuffle(fours[2], fours[3], 0, 4, 8, 12, 16, 20, 24, 28, 0, 0, 0, 0, 0, 0, 0, 0);
  wasm_v128_store(to, wasm_i64x2_shuffle(low, high, 0, 2));
}

inline void grey16_block(const std::uint8_t* p, int shift, std::uint8_t* to) {
  const v128_t most_level = wasm_u16x8_splat(255);
  const v128_t a = wasm_u16x8_min(wasm_u16x8_shr(wasm_v128_load(p), static_cast<std::uint32_t>(shift)), most_level);
  const v128_t b =
      wasm_u16x8_min(wasm_u16x8_shr(wasm_v128_load(p + 16), static_cast<std::uint32_t>(shift)), most_level);
  wasm_v128_store(to, wasm_u8x16_narrow_i16x8(a, b));
}

inline std::uint64_t masked_triplet_sum(const std::uint8_t* p, const std::uint8_t* dark, std::uint8_t level) {
  const v128_t mask = wasm_u8x16_ge(wasm_v128_load(dark), wasm_u8x16_splat(level));
  const Triplets t = triplets_of(p);
  return static_cast<std::uint64_t>(sum({wasm_v128_and(t.a, mask)})) + sum({wasm_v128_and(t.b, mask)}) +
         sum({wasm_v128_and(t.c, mask)});
}

#include "level_tiles.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kWasmLoops = kLoops;

}  // namespace adit::kernels
