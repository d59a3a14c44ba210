// What all tests of the pixel loops need: each CPU target in turn, planes compared, how thorough to be.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "adit/cpu_target.hpp"
#include "reference/morphology_reference.hpp"

namespace adit::judging {

/// True with ADIT_TEST_GRID=small in the environment: for sanitizers and emulators, where a step takes 20.
inline bool grid_is_small() {
  const char* grid = std::getenv("ADIT_TEST_GRID");
  return grid != nullptr && std::string_view(grid) == "small";
}

/// One CPU target for the life of this object; then the one that was in use before.
class TargetInUse {
 public:
  explicit TargetInUse(std::string_view name) : before_(cpu_target()) {
    EXPECT_TRUE(use_cpu_target(name)) << "target " << name;
    EXPECT_EQ(cpu_target(), name);
  }
  ~TargetInUse() { use_cpu_target(before_); }
  TargetInUse(const TargetInUse&) = delete;
  TargetInUse& operator=(const TargetInUse&) = delete;

 private:
  std::string_view before_;
};

/// Where two planes first differ, in words; success when nowhere.
inline ::testing::AssertionResult same_levels(ConstPlaneView got, ConstPlaneView want) {
  if (got.width != want.width || got.height != want.height) return ::testing::AssertionFailure() << "sizes differ";
  int different = 0;
  int first_u = 0;
  int first_v = 0;
  for (int v = 0; v < got.height; ++v) {
    for (int u = 0; u < got.width; ++u) {
      if (got.row(v)[u] == want.row(v)[u]) continue;
      if (different == 0) first_u = u;
      if (different == 0) first_v = v;
      ++different;
    }
  }
  if (different == 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << different << " of " << got.width << " x " << got.height
                                       << " pixels differ; the first, (" << first_u << ", " << first_v << "), is "
                                       << int{got.row(first_v)[first_u]} << " and should be "
                                       << int{want.row(first_v)[first_u]};
}

/// A flat element by its shape and sides.
struct ElementShape {
  bool is_ellipse = false;
  int width = 1;   ///< px
  int height = 1;  ///< px

  [[nodiscard]] StructuringElement element() const {
    return is_ellipse ? StructuringElement::ellipse(width, height) : StructuringElement::rectangle(width, height);
  }
  [[nodiscard]] std::string name() const {
    std::string name = is_ellipse ? "ellipse " : "rectangle ";
    name.append(std::to_string(width)).append(" x ").append(std::to_string(height));
    return name;
  }
};

}  // namespace adit::judging
