#include "adit/cpu_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judging.hpp"

namespace adit {
namespace {

bool is_supported(std::string_view name) {
  const std::span<const std::string_view> names = supported_cpu_targets();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Run by CMake's add_test with one value of ADIT_TARGET after the other, known and unknown.
TEST(CpuTarget, InUseIsTheOneTheEnvironmentNames) {
  const char* wanted = std::getenv("ADIT_TARGET");
  const bool honoured = wanted != nullptr && is_supported(wanted);
  EXPECT_EQ(cpu_target(), honoured ? std::string_view(wanted) : supported_cpu_targets().front());
  EXPECT_EQ(cpu_target_request_refused(), wanted != nullptr && *wanted != '\0' && !honoured);
}

TEST(CpuTarget, ListEndsWithPlainAndNamesEachOnce) {
  ASSERT_FALSE(supported_cpu_targets().empty());
  EXPECT_EQ(supported_cpu_targets().back(), "plain");
  std::vector<std::string_view> names(supported_cpu_targets().begin(), supported_cpu_targets().end());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(CpuTarget, ListIsBestFirst) {
  const std::vector<std::string_view> best_first = {"avx512", "avx2", "sse41", "neon", "plain"};
  std::size_t place = 0;
  for (const std::string_view name : supported_cpu_targets()) {
    while (place < best_first.size() && best_first[place] != name) ++place;
    EXPECT_LT(place, best_first.size()) << name << " is unknown or out of order";
  }
}

TEST(CpuTarget, ListIsWhatTheMachineHas) {
#if defined(__x86_64__)
  EXPECT_EQ(is_supported("sse41"), __builtin_cpu_supports("sse4.1") != 0);
  EXPECT_EQ(is_supported("avx2"), __builtin_cpu_supports("avx2") != 0);
  // Bytes in 512 bits need BW; a target may ask for more of the family, never for less.
  const bool has_bytes = __builtin_cpu_supports("avx512bw") != 0;
  const bool has_family = has_bytes && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512cd");
  if (has_family) {
    EXPECT_TRUE(is_supported("avx512"));
  }
  if (!has_bytes) {
    EXPECT_FALSE(is_supported("avx512"));
  }
#elif defined(__aarch64__)
  EXPECT_TRUE(is_supported("neon"));
  EXPECT_FALSE(is_supported("avx2"));
#else
  GTEST_SKIP() << "no expectation for this architecture";
#endif
}

TEST(CpuTarget, EachOfTheListCanBeChosen) {
  const std::string_view before = cpu_target();
  for (const std::string_view name : supported_cpu_targets()) {
    // A copy elsewhere in memory: it is the letters that count.
    EXPECT_TRUE(use_cpu_target(std::string(name)));
    EXPECT_EQ(cpu_target(), name);
  }
  EXPECT_TRUE(use_cpu_target(before));
}

TEST(CpuTarget, UnknownAndUnsupportedAreRefusedAndChangeNothing) {
  for (const std::string_view before : supported_cpu_targets()) {
    const judging::TargetInUse in_use(before);
    for (const std::string_view name : {"", "best", "AVX2", "avx2 ", "avx", "avx5120", "sse4.1", "plai"}) {
      EXPECT_FALSE(use_cpu_target(name)) << '"' << name << '"';
      EXPECT_EQ(cpu_target(), before);
    }
    for (const std::string_view name : {"avx512", "avx2", "sse41", "neon"}) {
      if (is_supported(name)) continue;
      EXPECT_FALSE(use_cpu_target(name)) << name;
      EXPECT_EQ(cpu_target(), before);
    }
  }
}

}  // namespace
}  // namespace adit
