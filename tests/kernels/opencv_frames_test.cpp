// Erosion, dilation and closing against OpenCV, bit for bit, on whole frames with the elements that are used on them.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "opencv_reference.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::ElementShape;
using reference::Content;
using reference::Plane;

class OpencvFrames : public ::testing::TestWithParam<Content> {};

void judge(Content content, int width, int height, const ElementShape& shape) {
  MorphologyScratch scratch;
  const Plane in = reference::synthetic_plane(content, width, height, 11);
  SCOPED_TRACE(::testing::Message() << width << " x " << height << " px");
  judging::judge_by_opencv(in, shape, scratch);
}

TEST_P(OpencvFrames, Vga) {
  for (const ElementShape& shape : {ElementShape{true, 15, 15}, ElementShape{false, 15, 15}, ElementShape{true, 91, 91},
                                    ElementShape{false, 91, 91}, ElementShape{true, 101, 101},
                                    ElementShape{false, 101, 101}, ElementShape{true, 101, 15}}) {
    if (judging::grid_is_small() && shape.is_ellipse && shape.height > 15) continue;
    ASSERT_NO_FATAL_FAILURE(judge(GetParam(), 640, 480, shape));
  }
}

TEST_P(OpencvFrames, OddSides) {
  for (const ElementShape& shape :
       {ElementShape{true, 15, 15}, ElementShape{false, 101, 91}, ElementShape{true, 91, 91}}) {
    if (judging::grid_is_small() && shape.is_ellipse && shape.height > 15) continue;
    ASSERT_NO_FATAL_FAILURE(judge(GetParam(), 1001, 733, shape));
  }
}

INSTANTIATE_TEST_SUITE_P(Contents, OpencvFrames, ::testing::ValuesIn(reference::kContents),
                         [](const auto& content) { return std::string(to_string(content.param)); });

// Elements larger than those of the grid, on planes whose widths lie about powers of two.
TEST(OpencvLargeElements, OnNarrowAndOnWidePlanes) {
  const bool small = judging::grid_is_small();
  for (const int width : {40, 127, 128, 129, 255, 257, 511, 512, 513, 640, 1023, 1025}) {
    for (const ElementShape& shape :
         {ElementShape{true, 67, 67}, ElementShape{true, 77, 77}, ElementShape{true, 129, 127},
          ElementShape{true, 151, 41}, ElementShape{true, 31, 133}, ElementShape{true, 3, 101},
          ElementShape{false, 257, 129}, ElementShape{true, 255, 255}}) {
      if (small && (width + shape.height) % 4 != 0) continue;
      const int height = 20 + (width * 7 + shape.width) % 90;
      const Content content = width % 2 == 0 ? Content::kImpulses : Content::kGradient;
      ASSERT_NO_FATAL_FAILURE(judge(content, width, height, shape));
    }
  }
}

TEST(OpencvLargeFrame, ClosingOf3840x2160) {
  if (judging::grid_is_small()) GTEST_SKIP() << "ADIT_TEST_GRID=small";
  const ElementShape shape{true, 101, 101};
  const Plane in = reference::synthetic_plane(Content::kTunnel, 3840, 2160, 12);
  cv::Mat want;
  cv::morphologyEx(judging::as_mat(in), want, cv::MORPH_CLOSE, judging::opencv_element(shape));
  const StructuringElement element = shape.element();
  MorphologyScratch scratch;
  scratch.reserve(in.width, in.height, element);
  for (const std::string_view target : supported_cpu_targets()) {
    const judging::TargetInUse in_use(target);
    Plane out(in.width, in.height);
    close(in.view(), element, out.view(), scratch);
    EXPECT_TRUE(judging::same_levels(out.view(), judging::as_plane(want))) << target;
  }
}

}  // namespace
}  // namespace adit
