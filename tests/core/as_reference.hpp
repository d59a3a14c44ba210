// What "as the plain chain says" means, in one place.
#pragma once

#include <gtest/gtest.h>

#include "adit/finder.hpp"
#include "chain_reference.hpp"

namespace adit::test {

inline void expect_same_answer(const OpenSpace& seen, const reference::Answer& answer) {
  EXPECT_EQ(seen.status, answer.status);
  EXPECT_NEAR(seen.atmospheric_light, answer.atmospheric_light, 1e-9);
  EXPECT_EQ(seen.threshold_level, answer.threshold_level);
  EXPECT_NEAR(seen.area_fraction, answer.area_fraction, 1e-12);
  EXPECT_NEAR(seen.centroid_px.u_px, answer.u_px, 1e-6);
  EXPECT_NEAR(seen.centroid_px.v_px, answer.v_px, 1e-6);
}

}  // namespace adit::test
