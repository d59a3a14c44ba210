#include "adit/eval/figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace adit::eval {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

ScoredFrame frame(Verdict verdict, int place, double error_deg = kUnknown, double confidence = kUnknown) {
  ScoredFrame f;
  f.score.verdict = verdict;
  f.score.answered = verdict == Verdict::kHit || verdict == Verdict::kMiss || verdict == Verdict::kAnsweredNone;
  f.score.error_rad = error_deg * kDegree;
  f.score.confidence = confidence;
  f.place = place;
  return f;
}

TEST(Figures, RatesByHand) {
  const std::vector<ScoredFrame> frames{frame(Verdict::kHit, 4, 0.0, 0.95),
                                        frame(Verdict::kHit, 4, 2.0, 0.95),
                                        frame(Verdict::kMiss, 9, 10.0, 0.95),
                                        frame(Verdict::kRefusedOpen, 9),
                                        frame(Verdict::kRefusedNone, 2),
                                        frame(Verdict::kRefusedNone, 2),
                                        frame(Verdict::kAnsweredNone, 2, 33.0, 0.45),
                                        frame(Verdict::kNotCounted, 7, 44.0, 0.05)};
  const Figures f = figures_of(frames, {});
  EXPECT_EQ(f.frames, 8);
  EXPECT_EQ(f.places, 4);
  EXPECT_EQ(f.open, 4);
  EXPECT_EQ(f.none, 3);
  EXPECT_EQ(f.hits, 2);
  EXPECT_EQ(f.refused_none, 2);
  EXPECT_DOUBLE_EQ(f[Figure::kHitRate].value, 0.5);
  EXPECT_DOUBLE_EQ(f[Figure::kRefusedOpen].value, 0.25);
  EXPECT_DOUBLE_EQ(f[Figure::kRefusedNone].value, 2.0 / 3.0);
  EXPECT_NEAR(f[Figure::kError].value, 2.0, 1e-12) << "of 0, 2 and 10: open frames alone";
  // 0.95: two of three right; 0.45: none of one.
  EXPECT_NEAR(f[Figure::kCalibrationError].value, 0.75 * (0.95 - 2.0 / 3.0) + 0.25 * 0.45, 1e-12);
  EXPECT_TRUE(std::isnan(f[Figure::kOpenRatio].value));
  EXPECT_FALSE(f[Figure::kOpenRatio].interval);
  ASSERT_EQ(f.reliability.size(), 10u);
  EXPECT_EQ(f.reliability[9].count, 3.0);
}

TEST(Figures, IntervalsComeFromPlacesThatOccur) {
  // Place numbers with gaps are the same set.
  std::vector<ScoredFrame> dense, gaps;
  for (int place = 0; place < 6; ++place) {
    dense.push_back(frame(place < 3 ? Verdict::kHit : Verdict::kMiss, place, 1.0 + place));
    gaps.push_back(frame(place < 3 ? Verdict::kHit : Verdict::kMiss, 100 * place + 3, 1.0 + place));
  }
  const Figures a = figures_of(dense, {}), b = figures_of(gaps, {});
  ASSERT_TRUE(a[Figure::kHitRate].interval && b[Figure::kHitRate].interval);
  EXPECT_EQ(a[Figure::kHitRate].interval->low, b[Figure::kHitRate].interval->low);
  EXPECT_LT(a[Figure::kHitRate].interval->low, 0.5);
  EXPECT_GT(a[Figure::kHitRate].interval->high, 0.5);
  EXPECT_EQ(a[Figure::kError].interval->high, b[Figure::kError].interval->high);
}

ScoredFrame heading(double azimuth_deg, int sequence, double yaw_deg = 0.0) {
  ScoredFrame f;
  f.score.azimuth_rad = azimuth_deg * kDegree;
  f.sequence = sequence;
  f.yaw_rad = yaw_deg * kDegree;
  return f;
}

TEST(Figures, JitterIsTheMeanChangeWithinASequence) {
  // 1 to 4 is a change of 3, 4 to 2 of 2; the other sequence runs in between; a refusal breaks the row.
  const std::vector<ScoredFrame> frames{heading(1, 0), heading(50, 1),       heading(4, 0),  heading(51, 1),
                                        heading(2, 0), heading(kUnknown, 0), heading(30, 0), heading(-80, -1)};
  EXPECT_NEAR(figures_of(frames, {})[Figure::kJitter].value, (3.0 + 2.0 + 1.0) / 3.0, 1e-9);
  EXPECT_TRUE(std::isnan(figures_of({heading(1, -1), heading(9, -1)}, {})[Figure::kJitter].value));
}

TEST(Figures, TurningTowardsAFixedPlaceIsNoJitter) {
  // The camera turns 5 deg to the left: what it saw at 0 is now 5 deg to the right.
  EXPECT_NEAR(heading_change_rad(heading(0, 0, 10), heading(5, 0, 15)), 0.0, 1e-12);
  EXPECT_NEAR(heading_change_rad(heading(0, 0, 179), heading(0, 0, -179)), 2 * kDegree, 1e-12) << "the short way";
}

TEST(Figures, BranchesAreSummedOverFrames) {
  std::vector<ScoredFrame> frames(3);
  frames[0].score.branches = 2;
  frames[0].score.branches_found = 1;
  frames[0].score.named = 1;
  frames[0].score.named_right = 1;
  frames[1].score.branches = 3;
  frames[1].score.branches_found = 3;
  frames[1].score.named = 5;
  frames[1].score.named_right = 3;
  const Figures f = figures_of(frames, {});
  EXPECT_DOUBLE_EQ(f[Figure::kBranchRecall].value, 4.0 / 5.0);
  EXPECT_DOUBLE_EQ(f[Figure::kBranchPrecision].value, 4.0 / 6.0);
}

TEST(Figures, EveryFigureHasANameOfItsOwn) {
  for (int i = 0; i < kFigureCount; ++i)
    for (int k = 0; k < i; ++k) EXPECT_NE(to_string(static_cast<Figure>(i)), to_string(static_cast<Figure>(k)));
  for (int i = 0; i < kVerdictCount; ++i) EXPECT_FALSE(to_string(static_cast<Verdict>(i)).empty());
}

}  // namespace
}  // namespace adit::eval
