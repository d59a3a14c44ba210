// CPU target `neon` (aarch64): 16 bytes at a time.
#include <arm_neon.h>

#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 16;
  uint8x16_t v;
};

inline Bytes load(const std::uint8_t* p) { return {vld1q_u8(p)}; }
inline void store(std::uint8_t* p, Bytes a) { vst1q_u8(p, a.v); }
inline Bytes fill(std::uint8_t value) { return {vdupq_n_u8(value)}; }
inline Bytes smallest(Bytes a, Bytes b) { return {vminq_u8(a.v, b.v)}; }
inline Bytes largest(Bytes a, Bytes b) { return {vmaxq_u8(a.v, b.v)}; }
inline Bytes at_most(Bytes a, Bytes limit) { return {vcleq_u8(a.v, limit.v)}; }
inline Bytes minus(Bytes a, Bytes b) { return {vsubq_u8(a.v, b.v)}; }
inline bool any_above(Bytes a, Bytes b) { return vmaxvq_u8(vcgtq_u8(a.v, b.v)) != 0; }
inline std::uint32_t sum(Bytes a) { return vaddlvq_u8(a.v); }

constexpr int kTripletBlock = 16;
constexpr int kTripletExtra = 0;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  const uint8x16x3_t channel = vld3q_u8(p);
  vst1q_u8(to, vminq_u8(vminq_u8(channel.val[0], channel.val[1]), channel.val[2]));
}
inline int least(Bytes a) { return vminvq_u8(a.v); }
inline int most(Bytes a) { return vmaxvq_u8(a.v); }

// 16 columns of one row.
inline Bytes load_16_wide(const std::uint8_t* p, std::ptrdiff_t) { return load(p); }

// How often `level` stands in a tile of 256 bytes.
inline std::uint32_t occurrences(const Bytes* tile, std::uint8_t level) {
  const uint8x16_t wanted = vdupq_n_u8(level);
  uint8x16_t count = vdupq_n_u8(0);
  for (int i = 0; i < 16; ++i) count = vsubq_u8(count, vceqq_u8(tile[i].v, wanted));
  return vaddlvq_u8(count);
}

inline void quad_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  const uint8x16x4_t channel = vld4q_u8(p);
  vst1q_u8(to, vminq_u8(vminq_u8(channel.val[0], channel.val[1]), channel.val[2]));
}

inline void grey16_block(const std::uint8_t* p, int shift, std::uint8_t* to) {
  const int16x8_t down = vdupq_n_s16(static_cast<std::int16_t>(-shift));
  const uint16x8_t a = vshlq_u16(vreinterpretq_u16_u8(vld1q_u8(p)), down);
  const uint16x8_t b = vshlq_u16(vreinterpretq_u16_u8(vld1q_u8(p + 16)), down);
  vst1q_u8(to, vcombine_u8(vqmovn_u16(a), vqmovn_u16(b)));
}

inline std::uint64_t masked_triplet_sum(const std::uint8_t* p, const std::uint8_t* dark, std::uint8_t level) {
  const uint8x16_t mask = vcgeq_u8(vld1q_u8(dark), vdupq_n_u8(level));
  const uint8x16x3_t channel = vld3q_u8(p);
  return static_cast<std::uint64_t>(vaddlvq_u8(vandq_u8(channel.val[0], mask))) +
         vaddlvq_u8(vandq_u8(channel.val[1], mask)) + vaddlvq_u8(vandq_u8(channel.val[2], mask));
}

#include "level_tiles.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kNeonLoops = kLoops;

}  // namespace adit::kernels
