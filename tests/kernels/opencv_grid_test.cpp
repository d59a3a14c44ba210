// Erosion, dilation and closing against OpenCV, bit for bit: every width and every height from 1 to 64, every pair of
// them, each with a handful of the elements up to 65 px; so every element meets every border.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "opencv_reference.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::ElementShape;
using reference::Content;
using reference::Plane;

std::vector<ElementShape> all_shapes() {
  std::vector<ElementShape> shapes;
  for (const bool is_ellipse : {false, true}) {
    for (int side = 1; side <= 65; side += 2) shapes.push_back({is_ellipse, side, side});
    for (const int other : {1, 3, 15, 33, 65}) {
      for (const int side : {1, 5, 9, 17, 31, 65}) {
        if (side == other) continue;
        shapes.push_back({is_ellipse, side, other});
        shapes.push_back({is_ellipse, other, side});
      }
    }
  }
  return shapes;
}

/// Widths 8 b + 1 to 8 b + 8 for the parameter b, so that cores can share the work.
class OpencvGrid : public ::testing::TestWithParam<int> {};

TEST_P(OpencvGrid, AllHeightsTo64) {
  const std::vector<ElementShape> shapes = all_shapes();
  const bool small = judging::grid_is_small();
  const int cases = small ? 1 : 6;
  MorphologyScratch scratch;
  for (int width = 8 * GetParam() + 1; width <= 8 * GetParam() + 8; ++width) {
    for (int height = 1; height <= 64; ++height) {
      // Still every width and every height.
      if (small && (5 * width + height) % 7 != 0) continue;
      for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = reference::hash_of(
            static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), static_cast<std::uint64_t>(i));
        const Content content = reference::kContents[seed % 5];  // tunnels need room
        const ElementShape& shape = shapes[(seed >> 8U) % shapes.size()];
        const Plane in = reference::synthetic_plane(content, width, height, seed);
        judging::judge_by_opencv(in, shape, scratch);
        ASSERT_FALSE(HasFatalFailure()) << width << " x " << height << " px, " << to_string(content);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, OpencvGrid, ::testing::Range(0, 8));

}  // namespace
}  // namespace adit
