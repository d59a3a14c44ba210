#include "adit/tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adit {
namespace {

constexpr double kFrame_s = 0.05;

struct Seen {
  double azimuth_rad;
  double score;
};

OpenSpace with(std::initializer_list<Seen> openings) {
  OpenSpace space;
  space.status = openings.size() > 0 ? Status::kFound : Status::kNoOpening;
  for (const Seen& seen : openings) {
    Opening& opening = space.openings[static_cast<std::size_t>(space.opening_count++)];
    opening.bearing.azimuth_rad = seen.azimuth_rad;
    opening.score = opening.confidence = seen.score;
  }
  if (space.opening_count > 0) space.bearing = space.openings[0].bearing;
  return space;
}

TEST(OpeningTracker, FollowsAnOpening) {
  OpeningTracker tracker;
  EXPECT_EQ(tracker.chosen(), nullptr);
  for (int i = 0; i < 40; ++i) tracker.update(with({{0.1 + 0.002 * i, 0.8}}), kFrame_s, 0.0);
  ASSERT_EQ(tracker.tracks().size(), 1u);
  ASSERT_NE(tracker.chosen(), nullptr);
  EXPECT_EQ(tracker.chosen()->id, 1u);
  EXPECT_NEAR(tracker.chosen()->bearing.azimuth_rad, 0.18, 0.02);
  EXPECT_NEAR(tracker.chosen()->score, 0.8, 0.05);
  EXPECT_NEAR(tracker.chosen()->age_s, 39 * kFrame_s, 1e-9);
}

TEST(OpeningTracker, TheYawRateKeepsATrackThroughATurn) {
  for (const double sign : {1.0, -1.0}) {
    OpeningTracker tracker;
    double azimuth = 0.0;
    for (int i = 0; i < 20; ++i) tracker.update(with({{azimuth, 0.8}}), kFrame_s, 0.0);
    // Nothing is seen for half a second of turning; the opening has moved on by more than the gate.
    for (int i = 0; i < 10; ++i) {
      azimuth += sign * 0.04;
      tracker.update(with({}), kFrame_s, sign * 0.04);
    }
    tracker.update(with({{azimuth, 0.8}}), kFrame_s, 0.0);
    ASSERT_EQ(tracker.tracks().size(), 1u);
    EXPECT_EQ(tracker.chosen()->id, 1u);
    EXPECT_NEAR(tracker.chosen()->bearing.azimuth_rad, azimuth, 0.01);
  }
}

TEST(OpeningTracker, TheChoiceDoesNotFlickerBetweenTwoAlike) {
  OpeningTracker tracker;
  int changes = 0;
  std::uint32_t last = 0;
  for (int i = 0; i < 400; ++i) {
    const double wobble = 0.15 * std::sin(1.7 * i);
    tracker.update(with({{-0.4, 0.6 + wobble}, {0.4, 0.6 - wobble}}), kFrame_s, 0.0);
    ASSERT_NE(tracker.chosen(), nullptr);
    if (i > 0 && tracker.chosen()->id != last) ++changes;
    last = tracker.chosen()->id;
  }
  EXPECT_LE(changes, 1);
  EXPECT_EQ(tracker.tracks().size(), 2u);
}

TEST(OpeningTracker, WhatIsMuchBetterForLongIsChosenInTheEnd) {
  OpeningTracker tracker;
  for (int i = 0; i < 40; ++i) tracker.update(with({{-0.4, 0.5}}), kFrame_s, 0.0);
  const std::uint32_t first = tracker.chosen()->id;
  for (int i = 0; i < 4; ++i) tracker.update(with({{0.4, 0.95}, {-0.4, 0.3}}), kFrame_s, 0.0);
  EXPECT_EQ(tracker.chosen()->id, first);
  for (int i = 0; i < 60; ++i) tracker.update(with({{0.4, 0.95}, {-0.4, 0.3}}), kFrame_s, 0.0);
  EXPECT_NE(tracker.chosen()->id, first);
}

TEST(OpeningTracker, ForgetsWhatIsNotSeenAnyMore) {
  OpeningTracker tracker;
  for (int i = 0; i < 40; ++i) tracker.update(with({{0.0, 0.9}}), kFrame_s, 0.0);
  tracker.update(with({}), kFrame_s, 0.0);
  EXPECT_NE(tracker.chosen(), nullptr);
  for (int i = 0; i < 80; ++i) tracker.update(with({}), kFrame_s, 0.0);
  EXPECT_EQ(tracker.chosen(), nullptr);
}

TEST(OpeningTracker, SurvivesMoreOpeningsThanItHolds) {
  OpeningTracker tracker;
  for (int i = 0; i < 30; ++i)
    tracker.update(with({{-1.4 + 0.7 * (i % 4), 0.5}, {2.0 + 0.3 * (i % 5), 0.4}, {-3.0 + 0.25 * (i % 7), 0.3}}),
                   kFrame_s, 0.0);
  EXPECT_LE(tracker.tracks().size(), kTracksMax);
  OpenSpace odd = with({{std::nan(""), 0.5}});
  odd.opening_count = 100;
  tracker.update(odd, std::nan(""), 0.0);
  tracker.update(odd, -1.0, 0.0);
}

}  // namespace
}  // namespace adit
