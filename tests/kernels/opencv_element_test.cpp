// The pixels of a structuring element are OpenCV's.
#include <gtest/gtest.h>

#include <cstdint>

#include "opencv_reference.hpp"

namespace adit {
namespace {

using judging::ElementShape;

void judge(const ElementShape& shape) {
  const StructuringElement element = shape.element();
  const cv::Mat want = judging::opencv_element(shape);
  ASSERT_EQ(element.width(), want.cols);
  ASSERT_EQ(element.height(), want.rows);
  for (int v = 0; v < want.rows; ++v) {
    const int half = element.half_chord(v);
    for (int u = 0; u < want.cols; ++u) {
      const bool covered = u >= shape.width / 2 - half && u <= shape.width / 2 + half;
      ASSERT_EQ(covered, want.at<std::uint8_t>(v, u) != 0) << shape.name() << ", pixel (" << u << ", " << v << ")";
    }
  }
}

TEST(OpencvElement, AllSidesUpTo101) {
  for (int width = 1; width <= 101; width += 2) {
    for (int height = 1; height <= 101; height += 2) {
      ASSERT_NO_FATAL_FAILURE(judge({true, width, height}));
      ASSERT_NO_FATAL_FAILURE(judge({false, width, height}));
    }
  }
}

TEST(OpencvElement, LargeOnes) {
  for (const int side : {103, 127, 129, 201, 255, 511, 777, 1023}) {
    ASSERT_NO_FATAL_FAILURE(judge({true, side, side}));
    ASSERT_NO_FATAL_FAILURE(judge({true, side, 1 + side / 3 * 2}));
    ASSERT_NO_FATAL_FAILURE(judge({true, 1 + side / 5 * 2, side}));
  }
}

}  // namespace
}  // namespace adit
