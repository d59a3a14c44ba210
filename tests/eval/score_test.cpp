#include "adit/eval/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace adit::eval {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
/// Focal length 100 px, principal point (50, 40): a tangent of 0.1 for every 10 px.
const Camera kCamera(CameraModel{101, 81, 100.0, 100.0, 50.0, 40.0, DistortionModel::kNone, {}});
const ScoreConfig kConfig;

Answer at(double u_px, double v_px, double confidence = 0.8) { return {true, {u_px, v_px}, confidence, {}}; }

FrameTruth marked(std::vector<Outline> outlines) {
  FrameTruth truth;
  truth.scene = outlines.empty() ? Scene::kNone : Scene::kOpen;
  truth.outlines = std::move(outlines);
  return truth;
}

/// Ranges of 2 m, but 40 m in the right third.
FrameTruth rendered() {
  FrameTruth truth;
  truth.scene = Scene::kOpen;
  truth.ranges = {101, 81, std::vector<float>(101 * 81, 2.0f)};
  for (std::size_t v = 0; v < 81; ++v)
    for (std::size_t u = 68; u < 101; ++u) truth.ranges.range_m[v * 101 + u] = 40.0f;
  truth.far_m = far_range_m(truth.ranges);
  return truth;
}

TEST(Score, AngleBetweenDirections) {
  EXPECT_NEAR(angle_between({0, 0}, {0.3, 0}), 0.3, 1e-12);
  EXPECT_NEAR(angle_between({0.5, 0}, {0.5, 0.2}), 0.2, 1e-12);
  EXPECT_NEAR(angle_between({0, 0}, {1e-9, 0}), 1e-9, 1e-15) << "small angles keep their digits";
  EXPECT_NEAR(angle_between({0, 0}, {std::numbers::pi, 0}), std::numbers::pi, 1e-9);
  EXPECT_NEAR(angle_between({0.4, 80 * kDegree}, {0.4 + std::numbers::pi, 80 * kDegree}), 20 * kDegree, 1e-9)
      << "over the top";
}

TEST(Score, MarkedFrames) {
  const FrameTruth truth = marked({box_of({0, 0}, {20, 80}), box_of({70, 30}, {80, 50})});
  const FrameScore hit = score_of(truth, at(75, 40), kCamera, kConfig);
  EXPECT_EQ(hit.verdict, Verdict::kHit);
  EXPECT_EQ(hit.error_rad, 0.0);
  EXPECT_EQ(hit.confidence, 0.8);
  EXPECT_TRUE(std::isnan(hit.open_ratio));
  // Its nearest edge is 10 px to the right, on the axis' height: atan(0.2) - atan(0.1).
  const FrameScore miss = score_of(truth, at(60, 40), kCamera, kConfig);
  EXPECT_EQ(miss.verdict, Verdict::kMiss);
  EXPECT_NEAR(miss.error_rad, std::atan(0.2) - std::atan(0.1), 1e-12);
  EXPECT_NEAR(miss.azimuth_rad, std::atan(0.1), 1e-12);
  const FrameScore refused = score_of(truth, Answer{}, kCamera, kConfig);
  EXPECT_EQ(refused.verdict, Verdict::kRefusedOpen);
  EXPECT_TRUE(std::isnan(refused.error_rad));
  EXPECT_TRUE(std::isnan(refused.confidence));
}

TEST(Score, FramesWithoutAnOpening) {
  EXPECT_EQ(score_of(marked({}), Answer{}, kCamera, kConfig).verdict, Verdict::kRefusedNone);
  EXPECT_EQ(score_of(marked({}), at(1, 1), kCamera, kConfig).verdict, Verdict::kAnsweredNone);
  FrameTruth undecided;
  EXPECT_EQ(score_of(undecided, at(1, 1), kCamera, kConfig).verdict, Verdict::kNotCounted);
}

TEST(Score, OpenRatioIsRangeOverTheFarRange) {
  FrameTruth truth = rendered();
  EXPECT_EQ(truth.far_m, 40.0f);
  EXPECT_EQ(score_of(truth, at(80, 40), kCamera, kConfig).verdict, Verdict::kHit);
  EXPECT_EQ(score_of(truth, at(80, 40), kCamera, kConfig).open_ratio, 1.0);
  const FrameScore wall = score_of(truth, at(20, 40), kCamera, kConfig);
  EXPECT_NEAR(wall.open_ratio, 0.05, 1e-12);
  EXPECT_EQ(wall.verdict, Verdict::kMiss);
  EXPECT_EQ(score_of(truth, at(67.4, 40), kCamera, kConfig).verdict, Verdict::kMiss) << "67 is the last wall";
  EXPECT_EQ(score_of(truth, at(67.6, 40), kCamera, kConfig).verdict, Verdict::kHit);
  const FrameScore outside = score_of(truth, at(140, 40), kCamera, kConfig);
  EXPECT_TRUE(std::isnan(outside.open_ratio));
  EXPECT_EQ(outside.verdict, Verdict::kMiss);
}

TEST(Score, FarRangeIsTheNinetyNinthPercentile) {
  RangeImage image{20, 10, std::vector<float>(200)};
  for (std::size_t i = 0; i < 200; ++i) image.range_m[i] = static_cast<float>(i + 1);
  EXPECT_EQ(far_range_m(image), 198.0) << "rank ceil(0.99 * 200)";
  EXPECT_TRUE(std::isnan(far_range_m(RangeImage{})));
}

TEST(Score, PassageInSightIsAHitWhateverLiesBehindIt) {
  FrameTruth truth = rendered();
  truth.branches = {{-0.2, 0.0}};  // over rock of 2 m
  truth.deepest = Bearing{std::atan(0.4), 0.0};
  truth.passage = Bearing{-0.2, 0.2};
  const double u_px = 50.0 - 100.0 * std::tan(0.2 - 4.9 * kDegree);
  const FrameScore hit = score_of(truth, at(u_px, 40), kCamera, kConfig);
  EXPECT_EQ(hit.verdict, Verdict::kHit);
  EXPECT_NEAR(hit.error_rad, 4.9 * kDegree, 1e-9);
  EXPECT_NEAR(hit.passage_error_rad, 4.9 * kDegree, 1e-9) << "azimuth alone";
  EXPECT_NEAR(hit.deepest_error_rad, std::atan(0.4) + 0.2 - 4.9 * kDegree, 1e-9);
  EXPECT_EQ(score_of(truth, at(50.0 - 100.0 * std::tan(0.2 - 5.1 * kDegree), 40), kCamera, kConfig).verdict,
            Verdict::kMiss);
}

TEST(Score, ErrorIsToTheNearestOfBranchesAndDeepest) {
  FrameTruth truth = rendered();
  truth.branches = {{-0.3, 0.0}, {0.3, 0.0}};
  truth.deepest = Bearing{0.1, 0.0};
  EXPECT_NEAR(score_of(truth, at(50, 40), kCamera, kConfig).error_rad, 0.1, 1e-12);
  EXPECT_NEAR(score_of(truth, at(50 + 100 * std::tan(0.25), 40), kCamera, kConfig).error_rad, 0.05, 1e-12);
}

TEST(Score, SceneOfARenderedFrame) {
  constexpr bool none = false, one = true;
  EXPECT_EQ(scene_of(3.9, none, kConfig), Scene::kNone);
  EXPECT_EQ(scene_of(3.9, one, kConfig), Scene::kUndecided);
  EXPECT_EQ(scene_of(4.0, one, kConfig), Scene::kOpen);
  EXPECT_EQ(scene_of(7.9, none, kConfig), Scene::kUndecided);
  EXPECT_EQ(scene_of(8.0, none, kConfig), Scene::kOpen);
}

TEST(Score, StemOfAJunctionIsAWayOnToo) {
  FrameTruth truth = rendered();
  truth.branches = {{-0.4, 0.0}, {-0.3, 0.0}};
  truth.passage = Bearing{0.0, 0.0};
  const FrameScore score = score_of(truth, at(50, 40), kCamera, kConfig);
  EXPECT_EQ(score.verdict, Verdict::kHit);
  EXPECT_EQ(score.error_rad, 0.0);
  EXPECT_EQ(score.branches, 2) << "but no branch";
}

TEST(Score, BranchesArePairedOnceEach) {
  FrameTruth truth = rendered();
  truth.branches = {{-0.4, 0.0}, {0.0, 0.0}, {0.4, 0.0}};
  Answer answer = at(50, 40);
  const auto place = [](double azimuth_rad) { return Pixel{50 + 100 * std::tan(azimuth_rad), 40}; };
  answer.openings = {place(0.02), place(-0.02), place(0.4 + 9 * kDegree), place(0.4 - 11.5 * kDegree)};
  const FrameScore score = score_of(truth, answer, kCamera, kConfig);
  EXPECT_EQ(score.branches, 3);
  EXPECT_EQ(score.named, 4);
  EXPECT_EQ(score.branches_found, 2) << "the second at 0 finds its branch taken, the last is too far";
  EXPECT_EQ(score.named_right, 2);
  truth.branches.resize(1);
  EXPECT_EQ(score_of(truth, answer, kCamera, kConfig).branches, 0) << "no junction";
}

TEST(Score, BranchesOfMarkedFramesAreTheirOutlines) {
  const FrameTruth truth = marked({box_of({0, 0}, {20, 80}), box_of({70, 30}, {80, 50})});
  Answer answer = at(75, 40);
  const FrameScore one = score_of(truth, answer, kCamera, kConfig);
  EXPECT_EQ(one.branches, 2);
  EXPECT_EQ(one.branches_found, 1) << "without a list the answer itself is the list";
  EXPECT_EQ(one.named, 1);
  answer.openings = {{75, 40}, {50, 40}, {10, 40}};
  const FrameScore all = score_of(truth, answer, kCamera, kConfig);
  EXPECT_EQ(all.branches_found, 2);
  EXPECT_EQ(all.named, 3);
  const FrameScore refused = score_of(truth, Answer{}, kCamera, kConfig);
  EXPECT_EQ(refused.branches, 2);
  EXPECT_EQ(refused.branches_found, 0);
  EXPECT_EQ(refused.named, 0);
}

}  // namespace
}  // namespace adit::eval
