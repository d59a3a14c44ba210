#include "adit/eval/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit::eval {
namespace {

TEST(Bootstrap, MeansCountPlacesAsOftenAsTheyWereDrawn) {
  const std::vector<Sample> samples{{1.0, 1.0, 0}, {0.0, 1.0, 0}, {5.0, 10.0, 1}};
  EXPECT_DOUBLE_EQ(mean_of(samples, {}), 6.0 / 12.0);
  const int once_never[] = {1, 0}, thrice_once[] = {3, 1}, never[] = {0, 0};
  EXPECT_DOUBLE_EQ(mean_of(samples, once_never), 0.5);
  EXPECT_DOUBLE_EQ(mean_of(samples, thrice_once), 8.0 / 16.0);
  EXPECT_TRUE(std::isnan(mean_of(samples, never)));
  EXPECT_TRUE(std::isnan(mean_of({}, {})));
}

TEST(Bootstrap, Medians) {
  const std::vector<Sample> even{{1, 1, 0}, {2, 1, 1}, {4, 1, 0}, {8, 1, 1}};
  EXPECT_DOUBLE_EQ(median_of(even, {}), 3.0);
  const int first[] = {1, 0}, second[] = {0, 2}, both[] = {1, 3};
  EXPECT_DOUBLE_EQ(median_of(even, first), 2.5);
  EXPECT_DOUBLE_EQ(median_of(even, second), 5.0);
  EXPECT_DOUBLE_EQ(median_of(even, both), 3.0) << "1 2 2 2 | 4 8 8 8";
  EXPECT_DOUBLE_EQ(median_of({{7, 1, 0}}, {}), 7.0);
  EXPECT_TRUE(std::isnan(median_of({}, {})));
}

TEST(Bootstrap, CalibrationErrorByHand) {
  // Two answers at 0.9 of which one is right; three at 0.25, none right; one at 1, right.
  const std::vector<Claim> claims{{0.9, true, 0},   {0.9, false, 0},  {0.25, false, 1},
                                  {0.25, false, 1}, {0.25, false, 1}, {1.0, true, 2}};
  const auto bins = reliability_of(claims, {});
  EXPECT_EQ(bins[9].count, 3.0);
  EXPECT_NEAR(bins[9].confidence, 2.8 / 3.0, 1e-12);
  EXPECT_NEAR(bins[9].right, 2.0 / 3.0, 1e-12);
  EXPECT_EQ(bins[2].count, 3.0);
  EXPECT_EQ(bins[2].right, 0.0);
  EXPECT_NEAR(calibration_error_of(claims, {}), 0.5 * (0.8 / 3.0) + 0.5 * 0.25, 1e-12);
  const int only_second[] = {0, 5, 0};
  EXPECT_NEAR(calibration_error_of(claims, only_second), 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(calibration_error_of({}, {})));
}

std::vector<Sample> twenty_places() {
  std::vector<Sample> samples;
  for (int place = 0; place < 20; ++place) samples.push_back({place < 5 ? 1.0 : 0.0, 1.0, place});
  return samples;
}

Interval interval(const std::vector<Sample>& samples, int places, const BootstrapConfig& config) {
  return Bootstrap(places, config).interval_of([&](PlaceWeights w) { return mean_of(samples, w); }).value();
}

TEST(Bootstrap, IntervalOfAShareIsTheBinomials) {
  // 5 of 20: the 2.5th and the 97.5th percentile of a binomial of 20 and 0.25 are 2 and 9.
  const Interval i = interval(twenty_places(), 20, {.resamples = 20000});
  EXPECT_NEAR(i.low, 0.10, 1e-9);
  EXPECT_NEAR(i.high, 0.45, 1e-9);
}

TEST(Bootstrap, FramesOfOnePlaceDoNotMakeTheIntervalNarrower) {
  std::vector<Sample> many;
  for (const Sample& sample : twenty_places())
    for (int i = 0; i < 50; ++i) many.push_back(sample);
  const Interval few = interval(twenty_places(), 20, {}), alike = interval(many, 20, {});
  EXPECT_DOUBLE_EQ(few.low, alike.low);
  EXPECT_DOUBLE_EQ(few.high, alike.high);
}

TEST(Bootstrap, SeedMakesTheSameIntervalAndAnotherSeedAnother) {
  // Values that differ all, so that percentiles do too.
  std::vector<Sample> samples;
  for (int place = 0; place < 20; ++place) samples.push_back({std::sqrt(place + 2.0), 1.0, place});
  const Interval a = interval(samples, 20, {.seed = 7}), b = interval(samples, 20, {.seed = 7});
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  const Interval c = interval(samples, 20, {.seed = 8});
  EXPECT_NE(a.low, c.low);
  EXPECT_NEAR(a.low, c.low, 0.05);
}

TEST(Bootstrap, TellsWhenThereIsNothingToTell) {
  const std::vector<Sample> samples{{1.0, 1.0, 0}, {0.0, 1.0, 0}};
  const auto mean = [&](PlaceWeights w) { return mean_of(samples, w); };
  EXPECT_FALSE(Bootstrap(1, {}).interval_of(mean)) << "one place says nothing of others";
  EXPECT_FALSE(Bootstrap(40, {}).interval_of([](PlaceWeights w) { return w[0] > 1 ? 1.0 : std::nan(""); }));
  EXPECT_THROW(Bootstrap(3, {.resamples = 0}), std::invalid_argument);
  EXPECT_THROW(Bootstrap(3, {.coverage = 1.0}), std::invalid_argument);
}

TEST(Bootstrap, RandomNumbersAreThePublishedOnes) {
  // splitmix64 of seed 1234567, as its authors' C code gives them.
  RandomNumbers random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317ull);
  EXPECT_EQ(random.next(), 3203168211198807973ull);
  EXPECT_EQ(random.next(), 9817491932198370423ull);
}

}  // namespace
}  // namespace adit::eval
