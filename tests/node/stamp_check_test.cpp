#include "adit/node/stamp_check.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace adit::node {
namespace {

constexpr Time_ns kFrame_ns = kSecond_ns / 30;
constexpr Time_ns kBegin_ns = 1'700'000'000 * kSecond_ns;

TEST(StampCheckTest, ARegularStreamIsFresh) {
  StampCheck check;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(check.judge(kBegin_ns + i * kFrame_ns), StampVerdict::kFresh);
  EXPECT_EQ(check.lost(), 0);
  EXPECT_NEAR(check.interval_s(), 1.0 / 30.0, 1e-6);
}

TEST(StampCheckTest, DuplicatesAndFramesOutOfOrderAreNotUsed) {
  StampCheck check;
  check.judge(kBegin_ns);
  check.judge(kBegin_ns + 2 * kFrame_ns);
  EXPECT_EQ(check.judge(kBegin_ns + 2 * kFrame_ns), StampVerdict::kDuplicate);
  EXPECT_EQ(check.judge(kBegin_ns + kFrame_ns), StampVerdict::kReordered);
  EXPECT_FALSE(is_usable(StampVerdict::kDuplicate));
  EXPECT_FALSE(is_usable(StampVerdict::kReordered));
  // They do not move the line: the next is judged by the last good one.
  EXPECT_EQ(check.judge(kBegin_ns + 2 * kFrame_ns), StampVerdict::kDuplicate);
  EXPECT_EQ(check.judge(kBegin_ns + 3 * kFrame_ns), StampVerdict::kFresh);
  EXPECT_EQ(check.count(StampVerdict::kDuplicate), 2);
  EXPECT_EQ(check.count(StampVerdict::kReordered), 1);
}

TEST(StampCheckTest, ABagThatLoopsStartsAgain) {
  StampCheck check;
  check.judge(kBegin_ns + 60 * kSecond_ns);
  EXPECT_EQ(check.judge(kBegin_ns), StampVerdict::kRestarted);
  EXPECT_TRUE(is_usable(StampVerdict::kRestarted));
  EXPECT_EQ(check.judge(kBegin_ns + kFrame_ns), StampVerdict::kFresh);
}

TEST(StampCheckTest, AClockThatIsSetForwardIsAGap) {
  StampCheck check;
  check.judge(kBegin_ns);
  EXPECT_EQ(check.judge(kBegin_ns + 3600 * kSecond_ns), StampVerdict::kGap);
  EXPECT_EQ(check.judge(kBegin_ns + 3600 * kSecond_ns + kFrame_ns), StampVerdict::kFresh);
  EXPECT_EQ(check.lost(), 0);
}

TEST(StampCheckTest, MissingStampsAreSaidAndUsed) {
  StampCheck check;
  EXPECT_EQ(check.judge(0), StampVerdict::kMissing);
  EXPECT_EQ(check.judge(0), StampVerdict::kMissing);
  EXPECT_TRUE(is_usable(StampVerdict::kMissing));
  EXPECT_EQ(check.judge(kBegin_ns), StampVerdict::kFresh);
}

TEST(StampCheckTest, FramesThatAreMissingAreCounted) {
  StampCheck check;
  Time_ns stamp_ns = kBegin_ns;
  for (int i = 0; i < 40; ++i) {
    stamp_ns += (i % 10 == 9 ? 3 : 1) * kFrame_ns + (i % 2 == 0 ? 2'000'000 : -2'000'000);  // 2 ms of jitter
    check.judge(stamp_ns);
  }
  EXPECT_EQ(check.lost(), 8);  // two frames, four times
}

TEST(StampCheckTest, TheEndsOfTimeDoNoHarm) {
  StampCheck check;
  check.judge(1);
  check.judge(std::numeric_limits<Time_ns>::max());
  EXPECT_EQ(check.judge(1), StampVerdict::kRestarted);
}

}  // namespace
}  // namespace adit::node
