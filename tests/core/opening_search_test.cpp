// Where a place of the map is said to be.
#include "opening_search.hpp"

#include <gtest/gtest.h>

namespace adit {
namespace {

constexpr int kWidth = 80, kHeight = 60;

void fill(CellPlane& plane, int left, int top, int right, int bottom) {
  for (int v = top; v < bottom; ++v) std::fill(plane.row(v) + left, plane.row(v) + right, std::int16_t{3 * kStop});
}

Candidate strongest(const CellPlane& map) {
  SearchScratch scratch(map.width, map.height);
  const Candidates found = search_openings(map, map, scratch);
  EXPECT_GE(found.count, 1);
  return found.list[0];
}

TEST(OpeningSearch, APlaceAloneHasItsMiddleAtItsCentroid) {
  CellPlane map(kWidth, kHeight);
  fill(map, 30, 20, 50, 34);
  const Candidate found = strongest(map);
  EXPECT_NEAR(found.u, 39.5, 0.01);
  EXPECT_NEAR(found.v, 26.5, 0.01);
  EXPECT_NEAR(found.middle_v, 26.5, 0.01);
}

// The dark floor before the end of a passage is wide along the foot of the walls, and belongs to the same place.
TEST(OpeningSearch, AWideStripAtTheFootDoesNotPullTheMiddleDown) {
  CellPlane map(kWidth, kHeight);
  fill(map, 30, 20, 50, 34);
  fill(map, 4, 34, 76, 38);
  const Candidate found = strongest(map);
  EXPECT_NEAR(found.u, 39.5, 0.01);
  EXPECT_GT(found.v, 30.0);
  EXPECT_NEAR(found.middle_v, 28.5, 0.01);  // of rows 20 to 37
}

}  // namespace
}  // namespace adit
