#include <gtest/gtest.h>

#include <set>

#include "adit/finder.hpp"
#include "adit/heading.hpp"

namespace adit {
namespace {

/// Every value has a name of its own, and the name leads back to it.
template <class Enum>
void expect_names_lead_back(int count) {
  std::set<std::string_view> names;
  for (int i = 0; i < count; ++i) {
    const auto value = static_cast<Enum>(i);
    const std::string_view name = to_string(value);
    EXPECT_NE(name, "unknown");
    EXPECT_TRUE(names.insert(name).second) << name;
    auto parsed = static_cast<Enum>(count - 1 - i);
    EXPECT_TRUE(parse(name, parsed)) << name;
    EXPECT_EQ(parsed, value) << name;
  }
  EXPECT_EQ(to_string(static_cast<Enum>(count)), "unknown");
  auto untouched = static_cast<Enum>(count - 1);
  EXPECT_FALSE(parse("Found", untouched));
  EXPECT_FALSE(parse("", untouched));
  EXPECT_EQ(untouched, static_cast<Enum>(count - 1));
}

TEST(Names, LeadBack) {
  expect_names_lead_back<Status>(kStatusCount);
  expect_names_lead_back<Rule>(kRuleCount);
  expect_names_lead_back<Method>(2);
  expect_names_lead_back<Clustering>(2);
  expect_names_lead_back<DistortionModel>(4);
}

TEST(Names, AreThoseOfTheTables) {
  EXPECT_EQ(to_string(Status::kFound), "found");
  EXPECT_EQ(to_string(Status::kTooDark), "too_dark");
  EXPECT_EQ(to_string(Status::kTooBright), "too_bright");
  EXPECT_EQ(to_string(Status::kNoContrast), "no_contrast");
  EXPECT_EQ(to_string(Status::kNoRegion), "no_region");
  EXPECT_EQ(to_string(Status::kBadFrame), "bad_frame");
  EXPECT_EQ(to_string(Status::kWrongSize), "wrong_size");
  EXPECT_EQ(to_string(Status::kNoOpening), "no_opening");
  EXPECT_EQ(to_string(Status::kBlockedLens), "blocked_lens");
  EXPECT_EQ(to_string(Status::kDust), "dust");
  EXPECT_EQ(to_string(Status::kFrozenFrame), "frozen_frame");
  EXPECT_EQ(to_string(Status::kTornFrame), "torn_frame");
  EXPECT_EQ(to_string(Rule::kDarkestCluster), "darkest_cluster");
  EXPECT_EQ(to_string(Rule::kFlash), "flash");
  EXPECT_EQ(to_string(Method::kPaper), "paper");
  EXPECT_EQ(to_string(Clustering::kLloyd), "lloyd");
  EXPECT_EQ(to_string(Stage::kScatteringDepth), "scattering_depth");
  EXPECT_EQ(to_string(Stage::kMoments), "moments");
  EXPECT_EQ(to_string(HeadingState::kSteer), "steer");
  EXPECT_EQ(to_string(HeadingState::kHold), "hold");
  EXPECT_EQ(to_string(DistortionModel::kRationalPolynomial), "rational_polynomial");
}

}  // namespace
}  // namespace adit
