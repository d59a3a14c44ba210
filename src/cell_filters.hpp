// Filters on the small grid: all in whole numbers, so that every machine gives the same bits.
#pragma once

#include <array>

#include "reduced_frame.hpp"

namespace adit {

/// Two rows and a plane that the filters below work in.
struct FilterScratch {
  FilterScratch(int width, int height) : plane(width, height), line(static_cast<std::size_t>(width) + 4) {}
  CellPlane plane;
  std::vector<std::int16_t> line;
};

/// Smallest value of the 3 x 3 (5 x 5) cells about each; cells outside the grid take no part. In place.
void erode_3(CellPlane& plane, FilterScratch& scratch) noexcept;
void erode_5(CellPlane& plane, FilterScratch& scratch) noexcept;
/// The largest.
void dilate_3(CellPlane& plane, FilterScratch& scratch) noexcept;
void dilate_5(CellPlane& plane, FilterScratch& scratch) noexcept;
/// Binomial weights 1 4 6 4 1 in both directions: a Gaussian with a standard deviation of one cell. The outermost cells
/// are repeated beyond the border. Values must be below 2048 * 16 / 16: at most 4095. In place.
void blur(CellPlane& plane, FilterScratch& scratch) noexcept;

/// Light of the scene on a logarithmic scale, kStop units a factor of two, for each part of a grey level.
inline constexpr int kStop = 256;
using LightTable = std::array<std::int16_t, kLevelPartsMax + 1>;
/// @param gamma  exponent from grey level to light; @param noise_level  what noise adds, in grey levels: below it all
/// is equally dark.
void make_light_table(double gamma, double noise_level, LightTable& table);
void look_up(const CellPlane& levels, const LightTable& table, CellPlane& light) noexcept;

}  // namespace adit
