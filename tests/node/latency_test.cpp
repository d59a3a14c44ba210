#include "adit/node/latency.hpp"

#include <gtest/gtest.h>

namespace adit::node {
namespace {

constexpr Time_ns kMillisecond_ns = 1'000'000;

TEST(LatencyTest, NothingIsSaidOfNothing) { EXPECT_EQ(LatencyMeter().figures().count, 0u); }

TEST(LatencyTest, PercentilesAreNearestRank) {
  LatencyMeter meter;
  for (int i = 100; i >= 1; --i) meter.add(i * kMillisecond_ns);
  const LatencyFigures f = meter.figures();
  EXPECT_EQ(f.count, 100u);
  EXPECT_DOUBLE_EQ(f.p50_s, 0.050);
  EXPECT_DOUBLE_EQ(f.p90_s, 0.090);
  EXPECT_DOUBLE_EQ(f.p99_s, 0.099);
  EXPECT_DOUBLE_EQ(f.max_s, 0.100);
}

TEST(LatencyTest, OneIsAllPercentiles) {
  LatencyMeter meter;
  meter.add(7 * kMillisecond_ns);
  EXPECT_DOUBLE_EQ(meter.figures().p50_s, 0.007);
  EXPECT_DOUBLE_EQ(meter.figures().p99_s, 0.007);
}

TEST(LatencyTest, TheOldOnesGo) {
  LatencyMeter meter;
  for (std::size_t i = 0; i < LatencyMeter::kWindow; ++i) meter.add(kSecond_ns);
  for (std::size_t i = 0; i < LatencyMeter::kWindow; ++i) meter.add(kMillisecond_ns);
  EXPECT_DOUBLE_EQ(meter.figures().max_s, 0.001);
  EXPECT_EQ(meter.count(), static_cast<std::int64_t>(2 * LatencyMeter::kWindow));
}

TEST(LatencyTest, StampsOfTheFutureAreCountedApart) {
  LatencyMeter meter;
  meter.add(-kMillisecond_ns);
  EXPECT_EQ(meter.future_count(), 1);
  EXPECT_EQ(meter.figures().count, 0u);
}

}  // namespace
}  // namespace adit::node
