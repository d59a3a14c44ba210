// From a map of enclosure to a list of places.
#pragma once

#include <array>

#include "adit/finder.hpp"
#include "cell_filters.hpp"

namespace adit {

/// A place on the grid that may be an opening.
struct Candidate {
  double u = 0.0;  ///< centroid, cells, weighted by depth
  double v = 0.0;  ///< cells
  /// Middle of its height at u, cells. The floor before the end of a passage is met at a grazing angle and is darker
  /// than the end itself: it pulls v down, by 1 to 3 deg, and along the foot of the walls it is wide.
  double middle_v = 0.0;
  int left = 0;  ///< box about it, cells, both ends inside
  int right = 0;
  int top = 0;
  int bottom = 0;
  int cells = 0;           ///< area
  std::uint8_t owner = 0;  ///< its mark in SearchScratch::owner
  int peak = 0;            ///< largest value of the score map in it, parts of a stop
  double strength = 0.0;   ///< peak in stops times the square root of its share of the frame: deep and wide
  double rank = 0.0;       ///< what orders them: strength, until somebody knows better
};

struct SearchScratch {
  SearchScratch(int width, int height);
  /// Whose a cell of the map is.
  [[nodiscard]] std::uint8_t owner_of(int u, int v) const noexcept;

  int step;  ///< cells of the map along the side of one of the search
  std::size_t stride;
  /// 0 nobody's; i + 1 in candidate i; kSlope on the way down from one, and in
  /// the frame of one cell about the grid that saves every step the question whether it leaves the grid.
  std::vector<std::uint8_t> owner;
  std::vector<std::int16_t> value;  ///< of the map, on the same grid with its frame
  std::vector<std::int16_t> depth;  ///< likewise
  std::vector<std::int32_t> queue;
  std::vector<std::int16_t> row_peak;  ///< largest value of a row that is nobody's
};
inline constexpr std::uint8_t kSlope = 255;

struct Candidates {
  std::array<Candidate, kOpeningCountMax> list{};
  int count = 0;
};

/// The places of the map, the strongest first: cells about a peak with at least half its value, connected. Cells
/// on the way down from a place belong to nobody else, so that the rim of one is not taken for another.
/// @param map    not below 0; @param depth  the same size, not below 0: its fourth powers weigh the cells of a
/// centroid.
[[nodiscard]] Candidates search_openings(const CellPlane& map, const CellPlane& depth, SearchScratch& scratch) noexcept;

/// The highest rank first; equal ranks go by place. Allocates nothing.
void order_by_rank(Candidates& candidates) noexcept;

}  // namespace adit
