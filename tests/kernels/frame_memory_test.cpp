// Frames at the very edge of memory: the stages that read the camera's own pixels touch nothing beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "adit/dark_channel.hpp"
#include "adit/finder.hpp"
#include "adit/region.hpp"
#include "adit/scattering_depth.hpp"
#include "guarded_bytes.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::Against;
using judging::GuardedBytes;
using judging::TargetInUse;
using reference::Content;
using reference::Frame;
using reference::Layout;
using reference::Plane;

/// The frame's bytes between two forbidden pages, which nobody may write either.
class FrameAtTheEdge {
 public:
  FrameAtTheEdge(Frame frame, Against against) : bytes_(frame.bytes().size(), against), view_(frame.view()) {
    std::copy(frame.bytes().begin(), frame.bytes().end(), bytes_.data());
    view_.data = bytes_.data() + (frame.view().data - frame.bytes().data());
    bytes_.forbid_writing();
  }
  [[nodiscard]] const ImageView& view() const { return view_; }

 private:
  GuardedBytes bytes_;
  ImageView view_;
};

/// `judge` gets frames of every width from 16 to 80 at both edges, rows in either order, on each target.
template <class Judge>
void on_all(PixelFormat format, Judge judge) {
  for (int width = 16; width <= 80; width += judging::grid_is_small() ? 9 : 1) {
    for (const Layout layout : {Layout{0, false}, Layout{2, false}, Layout{0, true}}) {
      // With 16-bit pixels an odd number of bytes would lie at an odd address; 2 x width never is one.
      const Frame frame(Content::kNoise, format, width, 16 + width % 3, static_cast<std::uint64_t>(width), layout);
      for (const Against against : {Against::kFirstPage, Against::kLastPage}) {
        const FrameAtTheEdge at_the_edge(frame, against);
        for (const std::string_view target : supported_cpu_targets()) {
          const TargetInUse in_use(target);
          SCOPED_TRACE(::testing::Message() << width << " px wide, " << target);
          judge(at_the_edge.view());
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

class FrameMemory : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(FrameMemory, DarkChannelStaysInside) {
  const StructuringElement patch = StructuringElement::rectangle(3, 3);
  MorphologyScratch scratch;
  on_all(GetParam(), [&](const ImageView& view) {
    scratch.reserve(view.width, view.height, patch);
    const auto size = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    const GuardedBytes out(size, Against::kLastPage);
    const PlaneView plane{out.data(), view.width, view.height, view.width};
    dark_channel(view, patch, 12, plane, scratch);
    EXPECT_TRUE(judging::same_levels(plane, reference::dark_channel(view, 3, 12).view()));
  });
}

TEST_P(FrameMemory, AtmosphericLightStaysInside) {
  on_all(GetParam(), [](const ImageView& view) {
    const Plane dark = reference::dark_channel(view, 1, 12);
    const GuardedBytes bytes(dark.pixels.size(), Against::kLastPage);
    std::copy(dark.pixels.begin(), dark.pixels.end(), bytes.data());
    bytes.forbid_writing();
    const ConstPlaneView at_the_edge(bytes.data(), view.width, view.height, view.width);
    EXPECT_EQ(atmospheric_light(view, 12, at_the_edge, 0.1), reference::atmospheric_light(view, 12, dark, 0.1));
  });
}

TEST_P(FrameMemory, FindStaysInside) {
  OpenSpaceFinder finder(paper_preset());
  on_all(GetParam(), [&](const ImageView& view) { EXPECT_NE(finder.find(view).status, Status::kBadFrame); });
}

INSTANTIATE_TEST_SUITE_P(Formats, FrameMemory, ::testing::ValuesIn(reference::kFormats),
                         [](const auto& format) { return std::string(reference::to_string(format.param)); });

TEST(PlaneMemory, HistogramAndMomentsStayInside) {
  for (int width = 1; width <= 150; ++width) {
    const int height = 1 + width % 5;
    const Plane plane = reference::synthetic_plane(Content::kNoise, width, height, 3);
    for (const Against against : {Against::kFirstPage, Against::kLastPage}) {
      const GuardedBytes bytes(plane.pixels.size(), against);
      std::copy(plane.pixels.begin(), plane.pixels.end(), bytes.data());
      bytes.forbid_writing();
      const ConstPlaneView at_the_edge(bytes.data(), width, height, width);
      std::vector<std::uint32_t> columns(static_cast<std::size_t>(width));
      for (const std::string_view target : supported_cpu_targets()) {
        const TargetInUse in_use(target);
        ASSERT_EQ(histogram_of(at_the_edge), reference::histogram_of(plane)) << width << " px, " << target;
        ASSERT_EQ(moments_of(at_the_edge, 100, columns).m10, reference::moments_of(plane, 100).m10)
            << width << " px, " << target;
      }
    }
  }
}

}  // namespace
}  // namespace adit
