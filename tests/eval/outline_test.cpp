#include "adit/eval/outline.hpp"

#include <gtest/gtest.h>

namespace adit::eval {
namespace {

TEST(Outline, BoxHoldsItsEdgesInEitherOrderOfCorners) {
  for (const Outline& box : {box_of({10, 20}, {30, 40}), box_of({30, 40}, {10, 20})}) {
    for (const Pixel inside : {Pixel{20, 30}, {10, 20}, {30, 40}, {10, 40}, {30, 20}, {10, 30}, {20, 40}})
      EXPECT_TRUE(contains(box, inside)) << inside.u_px << " " << inside.v_px;
    for (const Pixel outside : {Pixel{9.9, 30}, {30.1, 30}, {20, 19.9}, {20, 40.1}, {9.9, 19.9}})
      EXPECT_FALSE(contains(box, outside)) << outside.u_px << " " << outside.v_px;
  }
}

/// A U: the notch between its arms is outside.
const Outline kU{{{0, 0}, {10, 0}, {10, 30}, {20, 30}, {20, 0}, {30, 0}, {30, 40}, {0, 40}}};

TEST(Outline, NotchOfAPolygonIsOutside) {
  EXPECT_TRUE(contains(kU, {5, 10}));
  EXPECT_TRUE(contains(kU, {25, 10}));
  EXPECT_TRUE(contains(kU, {15, 35}));
  EXPECT_FALSE(contains(kU, {15, 10}));
  EXPECT_TRUE(contains(kU, {15, 30})) << "its floor is an edge";
}

TEST(Outline, NearestIsThePlaceItselfInsideElseOnTheEdge) {
  EXPECT_EQ(nearest_of(kU, {5, 10}).u_px, 5.0);
  const Pixel notch = nearest_of(kU, {13, 10});
  EXPECT_EQ(notch.u_px, 10.0);
  EXPECT_EQ(notch.v_px, 10.0);
  const Pixel corner = nearest_of(kU, {33, 44});
  EXPECT_EQ(corner.u_px, 30.0);
  EXPECT_EQ(corner.v_px, 40.0);
}

TEST(Outline, WithoutCornersHoldsNothing) { EXPECT_FALSE(contains(Outline{}, {0, 0})); }

}  // namespace
}  // namespace adit::eval
