// Erosion, dilation and closing of planes that lie anywhere: padded rows, regions of a larger buffer, in place, at the
// very edge of memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "adit/morphology.hpp"
#include "guarded_bytes.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::Against;
using judging::ElementShape;
using judging::GuardedBytes;
using judging::TargetInUse;
using reference::Content;
using reference::Plane;

using Operation = void (*)(ConstPlaneView, const StructuringElement&, PlaneView, MorphologyScratch&) noexcept;
struct NamedOperation {
  const char* name;
  Operation run;
  Plane (*run_plainly)(const Plane&, const StructuringElement&);
};
constexpr NamedOperation kOperations[] = {{"erosion", erode, reference::erode},
                                          {"dilation", dilate, reference::dilate},
                                          {"closing", close, reference::close}};

constexpr ElementShape kShapes[] = {{false, 3, 3}, {false, 15, 15}, {true, 5, 5}, {true, 15, 15}, {true, 31, 7}};
constexpr int kWidths[] = {1, 2, 7, 15, 16, 17, 31, 32, 33, 47, 63, 64, 65, 100, 127, 128, 129, 130};

/// A plane that is a region of a larger buffer, canaries on all sides.
class Region {
 public:
  Region(const Plane& plane, int left, int right, std::uint8_t canary)
      : width_(plane.width),
        height_(plane.height),
        left_(left),
        stride_(left + plane.width + right),
        canary_(canary),
        bytes_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(plane.height + 2 * kRows), canary) {
    for (int v = 0; v < height_; ++v) std::copy_n(plane.view().row(v), width_, view().row(v));
  }

  [[nodiscard]] PlaneView view() { return {bytes_.data() + kRows * stride_ + left_, width_, height_, stride_}; }

  [[nodiscard]] bool canaries_live() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const int u = static_cast<int>(i) % stride_ - left_;
      const int v = static_cast<int>(i) / stride_ - kRows;
      const bool inside = u >= 0 && u < width_ && v >= 0 && v < height_;
      if (!inside && bytes_[i] != canary_) return false;
    }
    return true;
  }

 private:
  static constexpr int kRows = 3;
  int width_;
  int height_;
  int left_;
  int stride_;
  std::uint8_t canary_;
  std::vector<std::uint8_t> bytes_;
};

struct Case {
  Plane in;
  StructuringElement element;
  std::string name;
};

/// Every operation on every case and target. `judge` gets the case, the operation, the right answer and a scratch.
template <class Judge>
void on_all(Judge judge) {
  const bool small = judging::grid_is_small();
  for (const int width : kWidths) {
    for (const ElementShape& shape : kShapes) {
      if (small && (width + shape.width) % 3 != 0) continue;
      const int height = 1 + width * 7 % 23;
      const Case one{reference::synthetic_plane(Content::kImpulses, width, height, static_cast<std::uint64_t>(width)),
                     shape.element(), shape.name()};
      for (const NamedOperation& operation : kOperations) {
        const Plane want = operation.run_plainly(one.in, one.element);
        for (const std::string_view target : supported_cpu_targets()) {
          const TargetInUse in_use(target);
          SCOPED_TRACE(::testing::Message()
                       << operation.name << ", " << one.name << ", " << width << " x " << height << " px, " << target);
          MorphologyScratch scratch;
          scratch.reserve(width, height, one.element);
          judge(one, operation, want, scratch);
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

TEST(MorphologyMemory, InPlace) {
  on_all([](const Case& one, const NamedOperation& operation, const Plane& want, MorphologyScratch& scratch) {
    Plane plane = one.in;
    operation.run(plane.view(), one.element, plane.view(), scratch);
    EXPECT_TRUE(judging::same_levels(plane.view(), want.view()));
  });
}

// Two canary values, the worst for either operation: were one of them read, an answer would be wrong.
TEST(MorphologyMemory, RegionsOfLargerBuffers) {
  on_all([](const Case& one, const NamedOperation& operation, const Plane& want, MorphologyScratch& scratch) {
    for (const std::uint8_t canary : {std::uint8_t{0}, std::uint8_t{255}}) {
      Region in(one.in, 5, 2, canary);
      Region out(Plane(one.in.width, one.in.height, 99), 1, 70, canary);
      operation.run(in.view(), one.element, out.view(), scratch);
      EXPECT_TRUE(judging::same_levels(out.view(), want.view()));
      EXPECT_TRUE(judging::same_levels(in.view(), one.in.view())) << "the input was written";
      EXPECT_TRUE(in.canaries_live() && out.canaries_live()) << "written outside the plane";
    }
  });
}

TEST(MorphologyMemory, RegionInPlace) {
  on_all([](const Case& one, const NamedOperation& operation, const Plane& want, MorphologyScratch& scratch) {
    for (const std::uint8_t canary : {std::uint8_t{0}, std::uint8_t{255}}) {
      Region plane(one.in, 0, 13, canary);
      operation.run(plane.view(), one.element, plane.view(), scratch);
      EXPECT_TRUE(judging::same_levels(plane.view(), want.view()));
      EXPECT_TRUE(plane.canaries_live()) << "written outside the plane";
    }
  });
}

void judge_at_the_edge(Against against, int padding) {
  on_all([=](const Case& one, const NamedOperation& operation, const Plane& want, MorphologyScratch& scratch) {
    const int stride = one.in.width + padding;
    const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(one.in.height - 1) +
                      static_cast<std::size_t>(one.in.width);
    const GuardedBytes in_bytes(size, against);
    const GuardedBytes out_bytes(size, against);
    const PlaneView in{in_bytes.data(), one.in.width, one.in.height, stride};
    const PlaneView out{out_bytes.data(), one.in.width, one.in.height, stride};
    for (int v = 0; v < in.height; ++v) std::copy_n(one.in.view().row(v), in.width, in.row(v));
    in_bytes.forbid_writing();
    operation.run(in, one.element, out, scratch);
    EXPECT_TRUE(judging::same_levels(out, want.view()));
  });
}

TEST(MorphologyMemory, NothingAfterTheEndIsTouched) { judge_at_the_edge(Against::kLastPage, 0); }
TEST(MorphologyMemory, NothingAfterTheEndIsTouchedWithPadding) { judge_at_the_edge(Against::kLastPage, 9); }
TEST(MorphologyMemory, NothingBeforeTheBeginningIsTouched) { judge_at_the_edge(Against::kFirstPage, 0); }

}  // namespace
}  // namespace adit
