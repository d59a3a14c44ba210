#include "adit/sim/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::sim {
namespace {

TEST(Random, IsThePublishedGenerator) {
  // First numbers of the reference programme's demo: pcg32_srandom(42, 54).
  Random random(42, 54);
  for (const std::uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
    EXPECT_EQ(random.bits(), expected);
}

TEST(Random, NormalNumbersAreNormal) {
  Random random(7);
  const int n = 200000;
  double sum = 0.0, squares = 0.0, fourth = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3.0, 4.0 * std::sqrt(96.0 / n));
}

TEST(Random, StreamsOfOneSeedDiffer) {
  Random a(1, 1), b(1, 2);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) equal += a.bits() == b.bits();
  EXPECT_LT(equal, 3);
}

}  // namespace
}  // namespace adit::sim
