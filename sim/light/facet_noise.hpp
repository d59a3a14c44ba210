// Noise that is linear within each tetrahedron of a lattice: its gradient is constant there, so it makes flat facets
// with sharp edges, as broken rock has. (Kuhn's division of the cube into six tetrahedra, after a rotation with skew
// so that the cube's axes do not show.)
#pragma once

#include "lanes.hpp"

namespace adit::sim {
namespace {

struct FacetSample {
  float value;       ///< about [-1, 1]
  float gx, gy, gz;  ///< gradient with respect to the argument
};

/// Rotation with skew, a different one for each octave.
struct Lattice {
  float m[9];
};

// Orthonormal rotations times the skew (1 + 1/3) along the diagonal, rounded; any regular matrices of norm about one
// do.
inline constexpr Lattice kLattices[4] = {
    {{1.08f, 0.62f, 0.41f, -0.36f, 1.02f, 0.55f, 0.28f, -0.19f, 1.13f}},
    {{0.71f, -0.64f, 0.82f, 0.93f, 0.77f, -0.31f, -0.22f, 0.88f, 0.86f}},
    {{-0.52f, 1.01f, 0.56f, 0.67f, 0.43f, 1.07f, 1.05f, 0.39f, -0.58f}},
    {{0.37f, 0.91f, -0.83f, -0.94f, 0.59f, 0.66f, 0.78f, 0.41f, 0.95f}},
};

ADIT_LANE FacetSample facet_noise(float x, float y, float z, const Lattice& l, std::uint32_t seed) {
  const float a = l.m[0] * x + l.m[1] * y + l.m[2] * z;
  const float b = l.m[3] * x + l.m[4] * y + l.m[5] * z;
  const float c = l.m[6] * x + l.m[7] * y + l.m[8] * z;
  const std::int32_t ia = floor_int(a), ib = floor_int(b), ic = floor_int(c);
  const float fa = a - static_cast<float>(ia), fb = b - static_cast<float>(ib), fc = c - static_cast<float>(ic);
  constexpr std::uint32_t kA = 0x8da6b343u, kB = 0xd8163841u, kC = 0xcb1ab31fu;
  const std::uint32_t h0 = static_cast<std::uint32_t>(ia) * kA + static_cast<std::uint32_t>(ib) * kB +
                           static_cast<std::uint32_t>(ic) * kC + seed;
  // The tetrahedron is the one whose path over the cube's corners goes first along the axis of the largest fraction.
  const bool ab = fa >= fb, ac = fa >= fc, bc = fb >= fc;
  const bool a_first = ab && ac, b_first = !ab && bc;
  const bool a_last = !ab && !ac, b_last = ab && !bc;
  const std::uint32_t first = a_first ? kA : (b_first ? kB : kC);
  const std::uint32_t last = a_last ? kA : (b_last ? kB : kC);
  const float v0 = signed_unit(mixed(h0));
  const float v1 = signed_unit(mixed(h0 + first));
  const float v2 = signed_unit(mixed(h0 + kA + kB + kC - last));
  const float v3 = signed_unit(mixed(h0 + kA + kB + kC));
  const float g1 = v1 - v0, g2 = v2 - v1, g3 = v3 - v2;
  const float ga = a_first ? g1 : (a_last ? g3 : g2);
  const float gb = b_first ? g1 : (b_last ? g3 : g2);
  const bool c_first = !ac && !bc, c_last = ac && bc;
  const float gc = c_first ? g1 : (c_last ? g3 : g2);
  FacetSample s;
  s.value = v0 + fa * ga + fb * gb + fc * gc;
  s.gx = l.m[0] * ga + l.m[3] * gb + l.m[6] * gc;
  s.gy = l.m[1] * ga + l.m[4] * gb + l.m[7] * gc;
  s.gz = l.m[2] * ga + l.m[5] * gb + l.m[8] * gc;
  return s;
}

}  // namespace
}  // namespace adit::sim
