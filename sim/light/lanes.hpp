// Arithmetic that compilers turn into vector instructions: no branches, no calls, no tables but by gather.
// Included only by the files that are compiled per CPU target; everything has internal linkage for that reason.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace adit::sim {
namespace {

#define ADIT_LANE [[gnu::always_inline]] inline

ADIT_LANE float bits_to_float(std::int32_t i) {
  float f;
  std::memcpy(&f, &i, 4);
  return f;
}
ADIT_LANE std::int32_t float_to_bits(float f) {
  std::int32_t i;
  std::memcpy(&i, &f, 4);
  return i;
}
ADIT_LANE std::int32_t floor_int(float x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}
ADIT_LANE float clamped(float x, float low, float high) {
  x = x < low ? low : x;
  return x > high ? high : x;
}

/// 2^f for f in [-0.5, 0.5], of a number or of lanes of them: Taylor series of degree 6.
template <class Real>
ADIT_LANE Real exp2_series(const Real& f) {
  Real p = f * 1.5403530e-4f + 1.3333558e-3f;
  p = p * f + 9.6181291e-3f;
  p = p * f + 5.5504109e-2f;
  p = p * f + 2.4022651e-1f;
  p = p * f + 6.9314718e-1f;
  return p * f + 1.0f;
}
/// log2 of m in [1/sqrt 2, sqrt 2], likewise: series of atanh.
template <class Real>
ADIT_LANE Real log2_series(const Real& m) {
  const Real t = (m - 1.0f) / (m + 1.0f);
  const Real t2 = t * t;
  Real p = t2 * 0.3206f + 0.41219859f;
  p = p * t2 + 0.57707802f;
  p = p * t2 + 0.96179669f;
  p = p * t2 + 2.88539008f;
  return p * t;
}

/// 2^x for |x| < 120, relative error below 3e-7.
ADIT_LANE float exp2_lane(float x) {
  x = clamped(x, -120.0f, 120.0f);
  const std::int32_t i = floor_int(x + 0.5f);
  const float f = x - static_cast<float>(i);
  return exp2_series(f) * bits_to_float((i + 127) << 23);
}
ADIT_LANE float exp_lane(float x) { return exp2_lane(x * 1.44269504f); }

/// log2 of x > 0, absolute error below 2e-6.
ADIT_LANE float log2_lane(float x) {
  const std::int32_t b = float_to_bits(x);
  const std::int32_t e = (b - 0x3f3504f3) >> 23;
  const float m = bits_to_float(b - (e << 23));
  return log2_series(m) + static_cast<float>(e);
}

ADIT_LANE std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  h ^= h >> 15;
  return h;
}
/// [-1, 1)
ADIT_LANE float signed_unit(std::uint32_t h) {
  return static_cast<float>(static_cast<std::int32_t>(h)) * (1.0f / 2147483648.0f);
}

}  // namespace
}  // namespace adit::sim
