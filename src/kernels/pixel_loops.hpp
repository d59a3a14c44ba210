// The pixel loops that are compiled once for each CPU target. Everything above them is ordinary code.
#pragma once

#include <cstddef>
#include <cstdint>

namespace adit::kernels {

/// Columns that one answer of PixelLoops::compare_cells speaks for, px.
inline constexpr int kCellColumns = 64;

/// Loops that exist twice: with the smallest value (erosion) and with the largest (dilation).
struct OrderLoops {
  /// out[x] = best(a[x], b[x]). `out` may be `a` or `b`.
  void (*join)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out, int width);
  /// running[x] = best(running[x], row[x]); out[x] = best(running[x], suffix[x]).
  void (*fold)(const std::uint8_t* row, std::uint8_t* running, const std::uint8_t* suffix, std::uint8_t* out,
               int width);
  /// out[x] = best(in[x - shift], in[x], in[x + shift]), and also[x] where `also` is given. `out` is another row.
  void (*spread)(const std::uint8_t* in, int shift, const std::uint8_t* also, std::uint8_t* out, int width);
  /// Nested vertical windows of two neighbouring middles in one go. `rows` begins with the two middles; then, going
  /// outwards, the row above the upper one and the row below the lower one, and so on. out_upper[j][x] is the best over
  /// the 1 + 2 * reach[j] rows about the upper middle; out_lower the same for the lower. `reach` rises.
  void (*stack)(const std::uint8_t* const* rows, const int* reach, int count, std::uint8_t* const* out_upper,
                std::uint8_t* const* out_lower, int width);
  /// out[x] = best over i of left[i][x] and right[i][x]. count >= 1.
  void (*gather)(const std::uint8_t* const* left, const std::uint8_t* const* right, int count, std::uint8_t* out,
                 int width);
  /// For each cell of kCellColumns: does `row` go beyond `other` (be better than it) at any column, and the reverse?
  void (*compare_cells)(const std::uint8_t* row, const std::uint8_t* other, int cells, std::uint8_t* row_beyond,
                        std::uint8_t* other_beyond);
};

/// The brightest `wanted` values met so far, and what is sure about them.
struct BrightTail {
  std::uint64_t wanted = 1;       ///< >= 1
  std::uint64_t above_floor = 0;  ///< values above `floor`; fewer than `wanted`
  int floor = 0;                  ///< at least `wanted` values are at or above it, once that many have been met
  std::uint32_t counters[256]{};  ///< right for levels from `floor` on
};

struct PixelLoops {
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
#endif

}  // namespace adit::kernels
