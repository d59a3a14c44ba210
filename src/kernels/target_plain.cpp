// CPU target `plain`: C++ alone, for every machine. The compiler may vectorise it for the baseline of its architecture.
#include "pixel_loops.hpp"

namespace adit::kernels {
namespace {

struct Bytes {
  static constexpr int kLanes = 16;
  std::uint8_t v[kLanes];
};

template <class Rule>
inline Bytes each(Rule rule) {
  Bytes result;
  for (int i = 0; i < Bytes::kLanes; ++i) result.v[i] = static_cast<std::uint8_t>(rule(i));
  return result;
}

inline Bytes load(const std::uint8_t* p) {
  Bytes result;
  __builtin_memcpy(result.v, p, sizeof result.v);
  return result;
}
inline void store(std::uint8_t* p, const Bytes& a) { __builtin_memcpy(p, a.v, sizeof a.v); }
inline Bytes fill(std::uint8_t value) {
  return each([&](int) { return value; });
}
inline Bytes smallest(const Bytes& a, const Bytes& b) {
  return each([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline Bytes largest(const Bytes& a, const Bytes& b) {
  return each([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline Bytes at_most(const Bytes& a, const Bytes& limit) {
  return each([&](int i) { return a.v[i] <= limit.v[i] ? 255 : 0; });
}
inline Bytes minus(const Bytes& a, const Bytes& b) {
  return each([&](int i) { return a.v[i] - b.v[i]; });
}
inline bool any_above(const Bytes& a, const Bytes& b) {
  unsigned above = 0;
  for (int i = 0; i < Bytes::kLanes; ++i) above |= a.v[i] > b.v[i] ? 1u : 0u;
  return above != 0;
}
inline std::uint32_t sum(const Bytes& a) {
  std::uint32_t total = 0;
  for (int i = 0; i < Bytes::kLanes; ++i) total += a.v[i];
  return total;
}
inline int least(const Bytes& a) {
  int result = 255;
  for (const std::uint8_t value : a.v) result = value < result ? value : result;
  return result;
}
inline int most(const Bytes& a) {
  int result = 0;
  for (const std::uint8_t value : a.v) result = value > result ? value : result;
  return result;
}

// 16 columns of one row.
inline Bytes load_16_wide(const std::uint8_t* p, std::ptrdiff_t) { return load(p); }

// How often `level` stands in a tile of 256 bytes.
inline std::uint32_t occurrences(const Bytes* tile, std::uint8_t level) {
  Bytes count = fill(0);
  for (int i = 0; i < 16; ++i) {
    count = each([&](int lane) { return count.v[lane] + (tile[i].v[lane] == level ? 1 : 0); });
  }
  return sum(count);
}

inline std::uint8_t smaller(std::uint8_t a, std::uint8_t b) { return a < b ? a : b; }

constexpr int kTripletBlock = 16;
constexpr int kTripletExtra = 0;
inline void triplet_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  for (int i = 0; i < 16; ++i) to[i] = smaller(smaller(p[3 * i], p[3 * i + 1]), p[3 * i + 2]);
}

inline void quad_minimum_block(const std::uint8_t* p, std::uint8_t* to) {
  for (int i = 0; i < 16; ++i) to[i] = smaller(smaller(p[4 * i], p[4 * i + 1]), p[4 * i + 2]);
}

inline void grey16_block(const std::uint8_t* p, int shift, std::uint8_t* to) {
  std::uint16_t value[16];
  __builtin_memcpy(value, p, sizeof value);
  for (int i = 0; i < 16; ++i) {
    const unsigned level = static_cast<unsigned>(value[i]) >> shift;
    to[i] = static_cast<std::uint8_t>(level < 255u ? level : 255u);
  }
}

inline std::uint64_t masked_triplet_sum(const std::uint8_t* p, const std::uint8_t* dark, std::uint8_t level) {
  std::uint32_t total = 0;
  for (int i = 0; i < 16; ++i) {
    const unsigned all = static_cast<unsigned>(p[3 * i] + p[3 * i + 1] + p[3 * i + 2]);
    total += dark[i] >= level ? all : 0u;
  }
  return total;
}

#include "level_tiles.inl"
#include "loops.inl"

}  // namespace

const PixelLoops kPlainLoops = kLoops;

}  // namespace adit::kernels
