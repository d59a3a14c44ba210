#include "cell_filters.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/pixel_loops.hpp"

namespace adit {
namespace {

using Of3 = void (*)(const std::int16_t*, const std::int16_t*, const std::int16_t*, std::int16_t*, int);

/// A row with `margin` copies of its outermost values before and behind it.
const std::int16_t* padded(const std::int16_t* row, int width, int margin, FilterScratch& scratch) noexcept {
  std::int16_t* const line = scratch.line.data();
  std::fill_n(line, margin, row[0]);
  std::copy_n(row, width, line + margin);
  std::fill_n(line + margin + width, margin, row[width - 1]);
  return line;
}

void filter_3(CellPlane& plane, FilterScratch& scratch, Of3 of_3) noexcept {
  const int width = plane.width, last = plane.height - 1;
  for (int v = 0; v <= last; ++v) {
    const std::int16_t* const line = padded(plane.row(v), width, 1, scratch);
    of_3(line, line + 1, line + 2, scratch.plane.row(v), width);
  }
  for (int v = 0; v <= last; ++v) {
    const CellPlane& across = scratch.plane;
    of_3(across.row(std::max(0, v - 1)), across.row(v), across.row(std::min(last, v + 1)), plane.row(v), width);
  }
}

}  // namespace

void erode_3(CellPlane& plane, FilterScratch& scratch) noexcept {
  filter_3(plane, scratch, kernels::pixel_loops().cells.smallest_of_3);
}
void dilate_3(CellPlane& plane, FilterScratch& scratch) noexcept {
  filter_3(plane, scratch, kernels::pixel_loops().cells.largest_of_3);
}

void erode_5(CellPlane& plane, FilterScratch& scratch) noexcept {
  erode_3(plane, scratch);
  erode_3(plane, scratch);
}

void dilate_5(CellPlane& plane, FilterScratch& scratch) noexcept {
  dilate_3(plane, scratch);
  dilate_3(plane, scratch);
}

void blur(CellPlane& plane, FilterScratch& scratch) noexcept {
  const auto binomial = kernels::pixel_loops().cells.binomial_of_5;
  const int width = plane.width, last = plane.height - 1;
  for (int v = 0; v <= last; ++v) {
    const std::int16_t* const line = padded(plane.row(v), width, 2, scratch);
    const std::int16_t* const neighbours[] = {line, line + 1, line + 2, line + 3, line + 4};
    binomial(neighbours, scratch.plane.row(v), width);
  }
  for (int v = 0; v <= last; ++v) {
    const auto line = [&](int at) { return scratch.plane.row(std::clamp(at, 0, last)); };
    const std::int16_t* const neighbours[] = {line(v - 2), line(v - 1), line(v), line(v + 1), line(v + 2)};
    binomial(neighbours, plane.row(v), width);
  }
}

void make_light_table(double gamma, double noise_level, LightTable& table) {
  const double floor = std::pow((noise_level + 1.0) / 256.0, gamma);
  for (int part = 0; part <= kLevelPartsMax; ++part) {
    const double level = static_cast<double>(part) / kLevelParts;
    const double light = std::pow((level + 1.0) / 256.0, gamma) + floor;
    table[static_cast<std::size_t>(part)] = static_cast<std::int16_t>(std::lround(kStop * std::log2(light)));
  }
}

void look_up(const CellPlane& levels, const LightTable& table, CellPlane& light) noexcept {
  for (std::size_t i = 0; i < levels.values.size(); ++i) {
    light.values[i] = table[static_cast<std::size_t>(levels.values[i])];
  }
}

}  // namespace adit
