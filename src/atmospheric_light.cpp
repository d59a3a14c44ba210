#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstring>

#include "adit/scattering_depth.hpp"
#include "kernels/pixel_loops.hpp"

namespace adit {
namespace {

/// Sum of the colour channels of a pixel in grey levels; grey counts once.
unsigned channel_sum(const std::uint8_t* pixel, const ImageView& view, int grey16_depth_bits) {
  if (view.format == PixelFormat::kGrey8) return *pixel;
  if (view.format == PixelFormat::kGrey16) {
    std::uint16_t value = 0;
    std::memcpy(&value, pixel, sizeof value);
    return static_cast<unsigned>(std::min(value >> (grey16_depth_bits - 8), 255));
  }
  const std::ptrdiff_t next = view.channel_step();
  return static_cast<unsigned>(pixel[0] + pixel[next] + pixel[2 * next]);
}

/// For the formats and layouts that are too rare for a loop of their own.
std::uint64_t plain_sum_where_bright(const ImageView& view, int v, int grey16_depth_bits, const std::uint8_t* dark,
                                     int level) {
  const std::uint8_t* const from = view.row(v);
  const std::ptrdiff_t step = view.pixel_step();
  std::uint64_t sum = 0;
  for (int u = 0; u < view.width; ++u) {
    if (dark[u] >= level) sum += channel_sum(from + u * step, view, grey16_depth_bits);
  }
  return sum;
}

/// Rows that may have a pixel of the tail: a few of them, most often.
using RowMarks = std::bitset<kSideMax_px>;

/// The brightest `fraction` of a dark channel: tail.floor is the smallest level that belongs to it.
kernels::BrightTail brightest_of(ConstPlaneView dark, double fraction, RowMarks& rows) {
  const kernels::PixelLoops& loops = kernels::pixel_loops();
  const double pixels = static_cast<double>(dark.width) * dark.height;
  kernels::BrightTail tail;
  tail.wanted = static_cast<std::uint64_t>(std::max(1.0, std::ceil(fraction * pixels)));
  // The brightest rows first: the floor then stands near its final place at once, and few rows reach up to it.
  std::array<std::uint8_t, kSideMax_px> brightest;
  std::array<std::uint16_t, 257> rank{};  // of the first row that is so bright: rows that are brighter
  for (int v = 0; v < dark.height; ++v) {
    brightest[static_cast<std::size_t>(v)] = loops.largest_level(dark.row(v), dark.width);
    ++rank[brightest[static_cast<std::size_t>(v)]];
  }
  for (std::size_t level = 256; level > 0; --level) rank[level - 1] = rank[level - 1] + rank[level];
  std::array<std::uint16_t, kSideMax_px> order;
  for (int v = 0; v < dark.height; ++v) {
    order[rank[brightest[static_cast<std::size_t>(v)] + 1U]++] = static_cast<std::uint16_t>(v);
  }
  for (int i = 0; i < dark.height; ++i) {
    const std::size_t v = order[static_cast<std::size_t>(i)];
    if (brightest[v] < tail.floor) break;
    rows[v] = loops.count_tail(dark.row(static_cast<int>(v)), dark.width, &tail);
  }
  return tail;
}

}  // namespace

double atmospheric_light(const ImageView& view, int grey16_depth_bits, ConstPlaneView dark, double fraction) noexcept {
  RowMarks rows;
  const kernels::BrightTail tail = brightest_of(dark, fraction, rows);
  const auto count = static_cast<double>(tail.above_floor + tail.counters[tail.floor]);
  const auto floor = static_cast<std::uint8_t>(tail.floor);
  const int step = bytes_per_pixel(view.format);
  const bool is_rare = view.format == PixelFormat::kGrey16 || step == 4 || !view.is_packed();
  std::uint64_t sum = 0;
  for (int v = 0; v < view.height; ++v) {
    if (!rows[static_cast<std::size_t>(v)]) continue;
    if (is_rare) {
      sum += plain_sum_where_bright(view, v, grey16_depth_bits, dark.row(v), floor);
    } else {
      sum += kernels::pixel_loops().sum_where_bright(view.row(v), step, dark.row(v), floor, view.width);
    }
  }
  const double channels = step >= 3 ? 3.0 : 1.0;
  return static_cast<double>(sum) / (channels * count);
}

}  // namespace adit
