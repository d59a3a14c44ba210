#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <random>

#include "adit/kmeans.hpp"
#include "adit/scattering_depth.hpp"
#include "chain_reference.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using Values = std::array<double, 256>;

Values linear() {
  Values value{};
  for (std::size_t i = 0; i < 256; ++i) value[i] = static_cast<double>(i);
  return value;
}

std::map<double, std::uint64_t> pixels_of_value(const Values& value, const Histogram& histogram) {
  std::map<double, std::uint64_t> out;
  for (std::size_t i = 0; i < 256; ++i) {
    if (histogram[i] > 0) out[value[i]] += histogram[i];
  }
  return out;
}

long double cost_about_mean(const std::vector<std::pair<double, double>>& points, std::size_t first, std::size_t end) {
  long double weight = 0, moment = 0, cost = 0;
  for (std::size_t i = first; i < end; ++i) {
    weight += points[i].second;
    moment += static_cast<long double>(points[i].first) * points[i].second;
  }
  for (std::size_t i = first; i < end; ++i) {
    const long double off = points[i].first - moment / weight;
    cost += off * off * points[i].second;
  }
  return cost;
}

struct Best {
  long double cost = INFINITY;
  std::vector<std::size_t> ends;
};

/// Tries every partition, those with smaller darker clusters first; a later one must be truly better to be taken.
Best by_trying_all(const std::vector<std::pair<double, double>>& points, std::size_t clusters) {
  Best best;
  std::vector<std::size_t> ends;
  const long double whole = cost_about_mean(points, 0, points.size());
  const std::function<void(std::size_t, long double)> place = [&](std::size_t first, long double cost) {
    if (ends.size() + 1 == clusters) {
      const long double total = cost + cost_about_mean(points, first, points.size());
      if (total < best.cost - 1e-12L * whole) {
        best.cost = total;
        best.ends = ends;
        best.ends.push_back(points.size());
      }
      return;
    }
    const std::size_t left_over = clusters - ends.size() - 1;
    for (std::size_t end = first + 1; end + left_over <= points.size(); ++end) {
      ends.push_back(end);
      place(end, cost + cost_about_mean(points, first, end));
      ends.pop_back();
    }
  };
  place(0, 0.0L);
  return best;
}

TEST(KmeansExact, IsTheBestOfAllPartitionsTiesIncluded) {
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    // Small whole numbers at whole places: ties abound.
    Histogram histogram{};
    std::vector<std::pair<double, double>> points;
    std::vector<int> level_of;
    const int spread = test::between(random, 1, 3);
    const Values value = linear();
    for (int level = test::between(random, 0, 200); level < 256 && points.size() < 9;
         level += test::between(random, 1, spread)) {
      const int pixels = test::between(random, 1, round % 3 == 0 ? 1 : 5);
      histogram[static_cast<std::size_t>(level)] = static_cast<std::uint32_t>(pixels);
      points.emplace_back(level, pixels);
      level_of.push_back(level);
    }
    const int asked = test::between(random, 1, 6);
    const Clusters found = cluster_exact(value, histogram, asked);
    const std::size_t count = std::min(static_cast<std::size_t>(asked), points.size());
    ASSERT_EQ(static_cast<std::size_t>(found.count), count);
    const Best best = by_trying_all(points, count);
    ASSERT_NEAR(found.cost, static_cast<double>(best.cost), 1e-9);
    for (std::size_t c = 0; c < count; ++c) {
      ASSERT_EQ(found.last_level[c], level_of[best.ends[c] - 1]) << "round " << round << " cluster " << c;
    }
  }
}

TEST(KmeansExact, TiesGoToSmallerDarkerClusters) {
  Histogram histogram{};
  for (const std::size_t level : {10u, 11u, 12u, 13u, 14u}) histogram[level] = 7;
  const Clusters two = cluster_exact(linear(), histogram, 2);  // 2 + 3 or 3 + 2
  EXPECT_EQ(two.last_level[0], 11);
  const Clusters four = cluster_exact(linear(), histogram, 4);
  EXPECT_EQ(four.last_level[0], 10);
  EXPECT_EQ(four.last_level[1], 11);
  EXPECT_EQ(four.last_level[2], 12);
}

Histogram random_histogram(std::mt19937& random) {
  Histogram histogram{};
  const int empty_share = test::between(random, 0, 90);
  const int scale = 1 << test::between(random, 0, 18);
  for (auto& pixels : histogram) {
    if (test::between(random, 0, 99) >= empty_share) {
      pixels = static_cast<std::uint32_t>(test::between(random, 0, 9) * test::between(random, 1, scale));
    }
  }
  histogram[static_cast<std::size_t>(test::between(random, 0, 255))] += 1;
  return histogram;
}

Values random_values(std::mt19937& random) {
  const double a = test::between(random, 6, 255);
  return scattering_depth_table(transmission_table(a, 0.95, 0.01), 1.0);
}

TEST(KmeansExact, AgreesWithPlainDynamicProgrammingInLongDouble) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    Values value = random_values(random);
    const double offset = round % 3 == 0 ? 1e5 : 0.0;  // a common offset must not cost digits
    const double scale = round % 4 == 0 ? 1e-9 : 1.0;
    for (auto& v : value) v = scale * (v + offset);
    const Histogram histogram = random_histogram(random);
    const int count = test::between(random, 1, kClusterCountMax);
    const Clusters found = cluster_exact(value, histogram, count);
    const auto points = pixels_of_value(value, histogram);
    const auto least = static_cast<double>(reference::least_cost(points, count));
    const auto whole = static_cast<double>(reference::least_cost(points, 1));
    EXPECT_LE(found.cost, least * (1 + 1e-9) + 1e-12 * whole) << "round " << round;
    EXPECT_GE(found.cost, least * (1 - 1e-9) - 1e-12 * whole) << "round " << round;
  }
}

TEST(KmeansExact, NeverAboveAHundredLloydStarts) {
  std::mt19937 random(13);
  for (int round = 0; round < 100; ++round) {
    const Values value = random_values(random);
    const Histogram histogram = random_histogram(random);
    const int count = test::between(random, 2, 12);
    const Clusters exact = cluster_exact(value, histogram, count);
    const Clusters lloyd = cluster_lloyd(
        value, histogram, count,
        {.seed = static_cast<std::uint64_t>(round), .starts = 100, .iterations_max = 200, .tolerance = 0.0});
    EXPECT_LE(exact.cost, lloyd.cost * (1 + 1e-12)) << "round " << round;
  }
}

TEST(KmeansExact, WeightsCentresAndLevelsAreThoseOfTheClusters) {
  std::mt19937 random(17);
  for (int round = 0; round < 50; ++round) {
    const Values value = random_values(random);
    const Histogram histogram = random_histogram(random);
    const Clusters clusters = cluster_exact(value, histogram, 10);
    int level = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(clusters.count); ++c) {
      std::uint64_t pixels = 0;
      double moment = 0;
      for (; level <= clusters.last_level[c]; ++level) {
        pixels += histogram[static_cast<std::size_t>(level)];
        moment += histogram[static_cast<std::size_t>(level)] * value[static_cast<std::size_t>(level)];
      }
      ASSERT_EQ(clusters.weight[c], pixels);
      ASSERT_GT(pixels, 0u);
      ASSERT_NEAR(clusters.centre[c], moment / static_cast<double>(pixels), 1e-12);
      ASSERT_GT(histogram[static_cast<std::size_t>(clusters.last_level[c])], 0u);
      ASSERT_TRUE(c == 0 || clusters.centre[c] > clusters.centre[c - 1]);
    }
    for (; level < 256; ++level) ASSERT_EQ(histogram[static_cast<std::size_t>(level)], 0u);
  }
}

TEST(KmeansExact, LevelsOfEqualValueStayTogether) {
  // a = 20: from level 22 on the transmission lies on its floor.
  const Values value = scattering_depth_table(transmission_table(20.0, 0.95, 0.01), 1.0);
  Histogram histogram{};
  for (std::size_t level = 100; level < 200; ++level) histogram[level] = 5;
  const Clusters one = cluster_exact(value, histogram, 10);
  EXPECT_EQ(one.count, 1);
  EXPECT_EQ(one.last_level[0], 199);
  EXPECT_EQ(one.cost, 0.0);
  histogram[3] = 1;
  const Clusters two = cluster_exact(value, histogram, 10);
  EXPECT_EQ(two.count, 2);
  EXPECT_EQ(two.last_level[0], 3);
  EXPECT_EQ(two.last_level[1], 199);
}

TEST(KmeansExact, FewerLevelsThanClustersIsNoError) {
  Histogram histogram{};
  EXPECT_EQ(cluster_exact(linear(), histogram, 10).count, 0);
  histogram[0] = 3;
  EXPECT_EQ(cluster_exact(linear(), histogram, 10).count, 1);
  EXPECT_EQ(cluster_exact(linear(), histogram, 0).count, 0);
  histogram[255] = 0xFFFFFF00u;
  const Clusters two = cluster_exact(linear(), histogram, kClusterCountMax);
  EXPECT_EQ(two.count, 2);
  EXPECT_EQ(two.weight[1], 0xFFFFFF00u);
  EXPECT_EQ(two.cost, 0.0);
}

TEST(KmeansExact, TakesLittleTime) {
  Histogram histogram{};
  std::mt19937 random(19);
  for (std::size_t level = 4; level < 129; ++level) {
    histogram[level] = static_cast<std::uint32_t>(test::between(random, 1, 9000));
  }
  const Values value = scattering_depth_table(transmission_table(140.0, 0.95, 0.01), 1.0);
  double least_us = 1e9;
  double cost = 0.0;
  for (int i = 0; i < 300; ++i) {
    const auto start = std::chrono::steady_clock::now();
    cost += cluster_exact(value, histogram, 10).cost;
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    least_us = std::min(least_us, took.count());
  }
  EXPECT_GT(cost, 0.0);
  std::cout << "cluster_exact, 125 levels, K = 10: " << least_us << " us at best\n";
  RecordProperty("cluster_exact_us", std::to_string(least_us));
  EXPECT_LT(least_us, 2000.0);  // loose: debug builds, sanitizers and emulators run this too
}

}  // namespace
}  // namespace adit
