// The pixel loops that are compiled once for each CPU target. Everything above them is ordinary code.
#pragma once

#include <cstddef>
#include <cstdint>

namespace adit::kernels {

/// Rows that are taken in at once.
inline constexpr int kOperandsMax = 5;

/// Rows of a window that slides down.
inline constexpr int kWindowMax = 64;

/// Rows of bytes, `pitch` bytes from one to the next.
struct Rows {
  std::uint8_t* first;
  std::ptrdiff_t pitch;
};
struct ConstRows {
  const std::uint8_t* first;
  std::ptrdiff_t pitch;
};

/// Loops that exist twice: with the smallest value (erosion) and with the largest (dilation).
struct OrderLoops {
  /// Row by row out[x] = best over i of from[i][x]. count is 1 to kOperandsMax. In order, rows from the top and columns
  /// from the left: where the width is a multiple of 64, what is read may be what is written, but not before it.
  void (*best_of_rows)(const ConstRows* from, int count, Rows out, int width, int rows);
  /// The same for a first operand that is not in the nearest cache: it is asked for ahead.
  void (*best_of_far_rows)(const ConstRows* from, int count, Rows out, int width, int rows);
  /// out[x] of row v = best of from[x] in rows v..v+length-1; length is 2 to kWindowMax. In
  /// place, the width is a multiple of 64.
  void (*best_of_window)(ConstRows from, int length, Rows out, int width, int rows);
  /// out[x] of row v = best of from[x + du] in rows v and v + 2 dv, and of from[x] and from[x + 2 du] in row v + dv.
  /// du and dv >= 1. In place, the width is a multiple of 64.
  void (*best_of_lozenge)(ConstRows from, int du, int dv, Rows out, int width, int rows);
  /// running[x] = best(running[x], row[x]); out[x] = best(running[x], suffix[x]). What the next call will write is
  /// asked for: else a store to a plane that is in no near cache holds up all that follow.
  void (*fold)(const std::uint8_t* row, std::uint8_t* running, const std::uint8_t* suffix, std::uint8_t* out,
               const std::uint8_t* next_out, int width);
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
  std::uint8_t (*largest_level)(const std::uint8_t* row, int width);
  /// Takes one more row into the tail. False if no value of it can be among the brightest `wanted`.
  bool (*count_tail)(const std::uint8_t* row, int width, BrightTail* tail);
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
