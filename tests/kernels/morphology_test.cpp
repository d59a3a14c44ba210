// Erosion, dilation and closing against the plain version, small planes, every CPU target.
#include "adit/morphology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::ElementShape;
using judging::TargetInUse;
using reference::Content;
using reference::Plane;

void judge(const Plane& in, const ElementShape& shape, MorphologyScratch& scratch) {
  const StructuringElement element = shape.element();
  const Plane eroded = reference::erode(in, element);
  const Plane dilated = reference::dilate(in, element);
  const Plane closed = reference::erode(dilated, element);
  scratch.reserve(in.width, in.height, element);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    Plane out(in.width, in.height, 99);
    erode(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(judging::same_levels(out.view(), eroded.view())) << "erosion, " << shape.name() << ", " << target;
    dilate(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(judging::same_levels(out.view(), dilated.view())) << "dilation, " << shape.name() << ", " << target;
    close(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(judging::same_levels(out.view(), closed.view())) << "closing, " << shape.name() << ", " << target;
  }
}

const std::vector<ElementShape>& shapes() {
  static const std::vector<ElementShape> all = {
      {false, 1, 1}, {false, 3, 3},  {false, 5, 1},   {false, 1, 7},  {false, 15, 15}, {false, 31, 9}, {false, 9, 33},
      {true, 1, 1},  {true, 3, 3},   {true, 5, 5},    {true, 7, 7},   {true, 15, 15},  {true, 31, 31}, {true, 21, 5},
      {true, 5, 27}, {true, 1, 9},   {true, 9, 1},    {true, 65, 3},  {true, 3, 65},   {true, 33, 31}, {true, 17, 15},
      {true, 13, 9}, {false, 65, 3}, {false, 63, 65}, {true, 11, 13}, {true, 49, 1},
  };
  return all;
}

// Every width and every height from 1 to 80, in pairs that wander, each with another element.
TEST(Morphology, AgreesWithThePlainVersionOnSmallPlanes) {
  MorphologyScratch scratch;
  const int step = judging::grid_is_small() ? 5 : 1;
  for (int i = 0; i < 80; i += step) {
    const int width = 1 + i;
    const int height = 1 + i * 37 % 80;
    const auto seed = static_cast<std::uint64_t>(i);
    const Content content = reference::kContents[reference::hash_of(seed) % 6];
    SCOPED_TRACE(::testing::Message() << width << " x " << height << " px, " << to_string(content));
    const Plane in = reference::synthetic_plane(content, width, height, seed);
    ASSERT_NO_FATAL_FAILURE(judge(in, shapes()[static_cast<std::size_t>(i) % shapes().size()], scratch));
  }
}

// Impulses print the element itself: each shape on a plane that is larger and on one that is smaller than it.
TEST(Morphology, AgreesWithThePlainVersionForEveryShape) {
  MorphologyScratch scratch;
  const bool small = judging::grid_is_small();
  for (const ElementShape& shape : shapes()) {
    if (small && shape.width * shape.height > 400) continue;
    SCOPED_TRACE(shape.name());
    ASSERT_NO_FATAL_FAILURE(judge(reference::synthetic_plane(Content::kImpulses, 71, 45, 3), shape, scratch));
    ASSERT_NO_FATAL_FAILURE(judge(reference::synthetic_plane(Content::kNoise, 12, 10, 4), shape, scratch));
  }
}

TEST(Morphology, AgreesWithThePlainVersionForElementsMuchLargerThanThePlane) {
  MorphologyScratch scratch;
  const Plane in = reference::synthetic_plane(Content::kNoise, 9, 7, 5);
  for (const ElementShape& shape : {ElementShape{true, 255, 3}, ElementShape{true, 3, 255}, ElementShape{false, 301, 9},
                                    ElementShape{true, 129, 127}}) {
    SCOPED_TRACE(shape.name());
    ASSERT_NO_FATAL_FAILURE(judge(in, shape, scratch));
  }
}

TEST(Morphology, TakesTheLargestElement) {
  MorphologyScratch scratch;
  const Plane in = reference::synthetic_plane(Content::kNoise, 40, 30, 6);
  for (const bool is_ellipse : {false, true}) {
    const StructuringElement element = ElementShape{is_ellipse, 1023, 1023}.element();
    scratch.reserve(in.width, in.height, element);
    for (const std::string_view target : supported_cpu_targets()) {
      const TargetInUse in_use(target);
      Plane out(in.width, in.height);
      dilate(in.view(), element, out.view(), scratch);
      // It covers the plane from everywhere.
      EXPECT_EQ(out, Plane(in.width, in.height, *std::max_element(in.pixels.begin(), in.pixels.end()))) << target;
    }
  }
}

// What an earlier call left in the scratch must not show: a large, bright plane before a small, dark one.
TEST(Morphology, RemembersNothing) {
  const StructuringElement element = StructuringElement::ellipse(15, 15);
  const Plane bright(200, 150, 255);
  const Plane dark = reference::synthetic_plane(Content::kImpulses, 33, 21, 7);
  const Plane want = reference::close(dark, element);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    MorphologyScratch scratch;
    scratch.reserve(bright.width, bright.height, element);
    scratch.reserve(dark.width, dark.height, element);
    Plane out(bright.width, bright.height);
    close(bright.view(), element, out.view(), scratch);
    EXPECT_EQ(out, bright) << target;
    Plane out_dark(dark.width, dark.height);
    close(dark.view(), element, out_dark.view(), scratch);
    EXPECT_TRUE(judging::same_levels(out_dark.view(), want.view())) << target;
  }
}

// One scratch for the patch of the dark channel and the element of the closing, as the finder has it.
TEST(Morphology, OneScratchServesTwoElements) {
  const StructuringElement patch = StructuringElement::rectangle(31, 31);
  const StructuringElement element = StructuringElement::ellipse(9, 41);
  const Plane in = reference::synthetic_plane(Content::kImpulses, 47, 52, 8);
  const Plane eroded = reference::erode(in, patch);
  const Plane closed = reference::close(in, element);
  MorphologyScratch scratch;
  scratch.reserve(in.width, in.height, patch);
  scratch.reserve(in.width, in.height, element);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    for (int turn = 0; turn < 2; ++turn) {
      Plane out(in.width, in.height);
      erode(in.view(), patch, out.view(), scratch);
      EXPECT_TRUE(judging::same_levels(out.view(), eroded.view())) << target;
      close(in.view(), element, out.view(), scratch);
      EXPECT_TRUE(judging::same_levels(out.view(), closed.view())) << target;
    }
  }
}

}  // namespace
}  // namespace adit
