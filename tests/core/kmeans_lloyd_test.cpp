#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "adit/kmeans.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using Values = std::array<double, 256>;

Values linear() {
  Values value{};
  for (std::size_t i = 0; i < 256; ++i) value[i] = static_cast<double>(i);
  return value;
}

Histogram humps(std::mt19937& random) {
  Histogram histogram{};
  for (int hump = 0; hump < 6; ++hump) {
    const int middle = test::between(random, 0, 255);
    for (int level = std::max(0, middle - 12); level < std::min(256, middle + 12); ++level) {
      histogram[static_cast<std::size_t>(level)] += static_cast<std::uint32_t>(test::between(random, 0, 500));
    }
  }
  histogram[0] += 1;
  return histogram;
}

void expect_sound(const Clusters& clusters, const Histogram& histogram) {
  std::uint64_t pixels = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(clusters.count); ++c) {
    ASSERT_TRUE(std::isfinite(clusters.centre[c]));
    ASSERT_GT(clusters.weight[c], 0u) << "an empty cluster";
    if (c > 0) {
      ASSERT_GT(clusters.centre[c], clusters.centre[c - 1]);
      ASSERT_GT(clusters.last_level[c], clusters.last_level[c - 1]);
    }
    pixels += clusters.weight[c];
  }
  std::uint64_t all = 0;
  for (const auto weight : histogram) all += weight;
  ASSERT_EQ(pixels, all);
  ASSERT_TRUE(std::isfinite(clusters.cost) && clusters.cost >= 0.0);
}

TEST(KmeansLloyd, ClustersAreSoundFromAnyStart) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    const Histogram histogram = humps(random);
    const int count = test::between(random, 1, kClusterCountMax);
    const Clusters clusters = cluster_lloyd(linear(), histogram, count,
                                            {.seed = static_cast<std::uint64_t>(round),
                                             .starts = 1,
                                             .iterations_max = test::between(random, 1, 20),
                                             .tolerance = 0.0});
    expect_sound(clusters, histogram);
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
}

TEST(KmeansLloyd, TheSeedDecidesAndNothingElse) {
  std::mt19937 random(5);
  const Histogram histogram = humps(random);
  const auto cost_of = [&histogram](std::uint64_t seed) {
    return cluster_lloyd(linear(), histogram, 10, {.seed = seed, .starts = 1, .iterations_max = 5, .tolerance = 0.0})
        .cost;
  };
  EXPECT_EQ(cost_of(1), cost_of(1));
  int different = 0;
  for (std::uint64_t seed = 2; seed < 12; ++seed) different += cost_of(seed) != cost_of(1) ? 1 : 0;
  EXPECT_GT(different, 5);
}

TEST(KmeansLloyd, MoreStartsAndMoreIterationsNeverCostMore) {
  std::mt19937 random(9);
  for (int round = 0; round < 30; ++round) {
    const Histogram histogram = humps(random);
    double last = INFINITY;
    for (const int starts : {1, 2, 5, 20}) {
      const Clusters clusters =
          cluster_lloyd(linear(), histogram, 8, {.seed = 4, .starts = starts, .iterations_max = 50, .tolerance = 0.0});
      EXPECT_LE(clusters.cost, last);
      last = clusters.cost;
    }
    last = INFINITY;
    for (const int iterations : {1, 2, 4, 8, 16}) {
      const Clusters clusters = cluster_lloyd(linear(), histogram, 8,
                                              {.seed = 4, .starts = 1, .iterations_max = iterations, .tolerance = 0.0});
      EXPECT_LE(clusters.cost, last * (1 + 1e-12));
      EXPECT_LE(clusters.iterations, iterations);
      last = clusters.cost;
    }
  }
}

TEST(KmeansLloyd, EndsWhenNothingMoves) {
  Histogram histogram{};
  histogram[10] = histogram[20] = histogram[200] = 5;
  const Clusters clusters =
      cluster_lloyd(linear(), histogram, 3, {.seed = 1, .starts = 1, .iterations_max = 1000, .tolerance = 0.0});
  EXPECT_EQ(clusters.count, 3);
  EXPECT_EQ(clusters.iterations, 1);
  EXPECT_EQ(clusters.cost, 0.0);
}

TEST(KmeansLloyd, FewerLevelsThanClustersIsNoError) {
  Histogram histogram{};
  EXPECT_EQ(cluster_lloyd(linear(), histogram, 10, {}).count, 0);
  histogram[77] = 1;
  EXPECT_EQ(cluster_lloyd(linear(), histogram, 10, {}).count, 1);
  histogram[78] = 4000000000u;
  EXPECT_EQ(cluster_lloyd(linear(), histogram, 10, {}).count, 2);
}

TEST(KmeansLloyd, AClusterThatLostItsPointsTakesOne) {
  // A start that empties a cluster is rare; many starts on gappy histograms find some.
  std::mt19937 random(21);
  for (int round = 0; round < 3000; ++round) {
    Histogram histogram{};
    for (int i = 0; i < 12; ++i) {
      histogram[static_cast<std::size_t>(test::between(random, 0, 255))] =
          static_cast<std::uint32_t>(test::between(random, 1, 3) == 1 ? 100000 : 1);
    }
    expect_sound(
        cluster_lloyd(linear(), histogram, test::between(random, 2, 8),
                      {.seed = static_cast<std::uint64_t>(round), .starts = 1, .iterations_max = 30, .tolerance = 0.0}),
        histogram);
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
}

}  // namespace
}  // namespace adit
