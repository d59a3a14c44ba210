// Rows of the table of triangles, one a lane. Included only by the files that are compiled per CPU target.
#pragma once

#include "lane_vectors.hpp"
#include "tile.hpp"

namespace adit::sim {
namespace {

/// Half a TriangleRow of sixteen lanes, field by field.
struct alignas(64) RowLanes {
  float field[kTreeWidth][kTreeWidth];
};

#if defined(__AVX512F__)
/// Sixteen rows turned into sixteen columns: half the instructions and a fifth of the time of gathering each field.
ADIT_LANE void transpose(__m512 (&r)[16]) {
  __m512 a[16];
  for (int i = 0; i < 16; i += 2) {
    a[i] = _mm512_unpacklo_ps(r[i], r[i + 1]);
    a[i + 1] = _mm512_unpackhi_ps(r[i], r[i + 1]);
  }
  for (int i = 0; i < 16; i += 4) {
    r[i] = _mm512_shuffle_ps(a[i], a[i + 2], 0x44);
    r[i + 1] = _mm512_shuffle_ps(a[i], a[i + 2], 0xee);
    r[i + 2] = _mm512_shuffle_ps(a[i + 1], a[i + 3], 0x44);
    r[i + 3] = _mm512_shuffle_ps(a[i + 1], a[i + 3], 0xee);
  }
  // Quarters of a register hold fields k, 4 + k, 8 + k, 12 + k of four lanes.
  for (int k = 0; k < 4; ++k) {
    const __m512 low_01 = _mm512_shuffle_f32x4(r[k], r[4 + k], 0x44),
                 high_01 = _mm512_shuffle_f32x4(r[k], r[4 + k], 0xee);
    const __m512 low_23 = _mm512_shuffle_f32x4(r[8 + k], r[12 + k], 0x44),
                 high_23 = _mm512_shuffle_f32x4(r[8 + k], r[12 + k], 0xee);
    a[k] = _mm512_shuffle_f32x4(low_01, low_23, 0x88);
    a[4 + k] = _mm512_shuffle_f32x4(low_01, low_23, 0xdd);
    a[8 + k] = _mm512_shuffle_f32x4(high_01, high_23, 0x88);
    a[12 + k] = _mm512_shuffle_f32x4(high_01, high_23, 0xdd);
  }
  for (int i = 0; i < 16; ++i) r[i] = a[i];
}
#endif

/// Fields from `first` on, 0 or kTreeWidth; of the first triangle where a lane has none.
ADIT_LANE void take_rows(const TriangleRow* rows, const std::int32_t* triangle, int first, RowLanes& into) {
#if defined(__AVX512F__)
  __m512 r[16];
  for (int j = 0; j < kTreeWidth; ++j) r[j] = _mm512_load_ps(rows[triangle[j] < 0 ? 0 : triangle[j]].corner + first);
  transpose(r);
  for (int k = 0; k < kTreeWidth; ++k) _mm512_store_ps(into.field[k], r[k]);
#else
  const float* const table = rows->corner + first;
  for (int k = 0; k < kTreeWidth; ++k) {
    float* const field = into.field[k];
    _Pragma("GCC ivdep") for (int j = 0; j < kTreeWidth; ++j) field[j] =
        table[(triangle[j] < 0 ? 0 : triangle[j]) * kRowFloats + k];
  }
#endif
}

}  // namespace
}  // namespace adit::sim
