// The pixel loops that are compiled once for each CPU target. Everything above them is ordinary code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "sweep_recipe.hpp"

namespace adit::kernels {

/// Columns that one answer of PixelLoops::compare_cells speaks for, px.
inline constexpr int kCellColumns = 64;

/// Two neighbouring rows of results, and what they are made of.
struct SweepPair {
  /// The two middle rows; then, going outwards, the row above the upper one and the row below the lower one, and so on,
  /// up to the element's reach.
  const std::uint8_t* const* rows = nullptr;
  std::uint8_t* upper = nullptr;  ///< where the results go
  std::uint8_t* lower = nullptr;
};
/// Where a SweepLoop stands: one vector of a pair of rows.
struct SweepPlace {
  const SweepPair* pair = nullptr;
  std::ptrdiff_t x = 0;  ///< where in each of the rows the vector begins
};

/// Bytes of the state of a SweepLoop.
inline constexpr std::size_t kSweepStateBytes = 64 * (5 * SweepRecipe::kStepsMax + 2);

/// The best value over an element along a row of vectors, the state kept from call to call. Results come late: at
/// place i, those of place i - step_count are written, so that many places before the first are read too. Between two
/// rows stands one vector of values that are never better.
using SweepLoop = void (*)(std::uint8_t* state, const SweepPlace* places, int count);
struct SweepLoops {
  SweepLoop of_half[kSweepHalfMax_px];  ///< [half - 1]: for the element of 2 * half + 1 rows and columns; may be null
};

/// Loops that exist twice: with the smallest value (erosion) and with the largest (dilation).
struct OrderLoops {
  /// out[x] = best(a[x], b[x]). `out` may be `a` or `b`.
  void (*join)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out, int width);
  /// running[x] = best(running[x], row[x]); out[x] = best(running[x], suffix[x]).
  void (*fold)(const std::uint8_t* row, std::uint8_t* running, const std::uint8_t* suffix, std::uint8_t* out,
               int width);
  /// out[x] = best over i of left[i][x] and right[i][x]. count >= 1.
  void (*gather)(const std::uint8_t* const* left, const std::uint8_t* const* right, int count, std::uint8_t* out,
                 int width);
  /// For each cell of kCellColumns: does `row` go beyond `other` (be better than it) at any column, and the reverse?
  void (*compare_cells)(const std::uint8_t* row, const std::uint8_t* other, int cells, std::uint8_t* row_beyond,
                        std::uint8_t* other_beyond);
  SweepLoops round;
  SweepLoops square;  ///< for erosion only: nothing dilates by a square in a hurry
};

/// The brightest `wanted` values met so far, and what is sure about them.
struct BrightTail {
  std::uint64_t wanted = 1;       ///< >= 1
  std::uint64_t above_floor = 0;  ///< values above `floor`; fewer than `wanted`
  int floor = 0;                  ///< at least `wanted` values are at or above it, once that many have been met
  std::uint32_t counters[256]{};  ///< right for levels from `floor` on
};

/// Loops over rows of cells. `out` is none of the others.
struct CellLoops {
  /// out[x] = smallest (largest) of a[x], b[x], c[x].
  void (*smallest_of_3)(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::int16_t* out,
                        int width);
  void (*largest_of_3)(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::int16_t* out,
                       int width);
  /// Weights 1 4 6 4 1 over 16, rounded; values 0 to 4080.
  void (*binomial_of_5)(const std::int16_t* const* rows, std::int16_t* out, int width);
  /// out[x] = larger of light[x] and met[x], less `step`.
  void (*carry_rays)(const std::int16_t* light, const std::int16_t* met, int step, std::int16_t* out, int width);
  /// Of eight values a cell, none taken for less than light[x]: the mean of the second, third and (twice) fourth
  /// smallest, less light[x].
  void (*rate_rises)(const std::int16_t* const* met, const std::int16_t* light, std::int16_t* out, int width);
};

struct PixelLoops {
  int lanes;  ///< bytes of a vector
  OrderLoops smallest;
  OrderLoops largest;
  /// Smallest of 3 interleaved channels.
  void (*triplet_minimum)(const std::uint8_t* from, std::uint8_t* to, int width);
  /// Smallest of the first 3 of 4 interleaved channels.
  void (*quad_minimum)(const std::uint8_t* from, std::uint8_t* to, int width);
  /// min(value >> shift, 255) of 16-bit values.
  void (*grey16_to_8)(const std::uint8_t* from, int shift, std::uint8_t* to, int width);
  /// Adds the values of a plane to 256 counters.
  void (*count_levels)(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height,
                       std::uint32_t* counters);
  /// Takes one more row into the tail.
  void (*count_tail)(const std::uint8_t* row, int width, BrightTail* tail);
  /// Adds 1 to columns[x] for each row whose value there is at most `last_level`; rows[v] = how many in row v.
  /// At most 255 rows.
  void (*count_mask)(const std::uint8_t* plane, std::ptrdiff_t stride, int width, int height, std::uint8_t last_level,
                     std::uint8_t* columns, std::uint32_t* rows);
  /// Sum of all channels of the pixels whose `dark` is at least `level`; `channels` is 3, or 1 for 8-bit grey.
  std::uint64_t (*sum_where_bright)(const std::uint8_t* from, int channels, const std::uint8_t* dark,
                                    std::uint8_t level, int width);
  CellLoops cells;
};

/// The loops of the target in use (cpu_target.hpp).
[[nodiscard]] const PixelLoops& pixel_loops() noexcept;

extern const PixelLoops kPlainLoops;
#if defined(ADIT_TARGETS_X86)
extern const PixelLoops kSse41Loops;
extern const PixelLoops kAvx2Loops;
extern const PixelLoops kAvx512Loops;
#elif defined(ADIT_TARGETS_NEON)
extern const PixelLoops kNeonLoops;
#elif defined(ADIT_TARGETS_WASM)
extern const PixelLoops kWasmLoops;
#endif

}  // namespace adit::kernels
