// The whole chain gives the same bits on every CPU target: every number of OpenSpace but the times.
#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "adit/finder.hpp"
#include "judging.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit {
namespace {

using judging::TargetInUse;
using reference::Content;
using reference::Frame;

/// All that OpenSpace holds, times left out, each as bits under its name.
class Bits {
 public:
  explicit Bits(const OpenSpace& space) {
    add("status", static_cast<std::uint64_t>(space.status));
    add("confidence", space.confidence);
    add("opening_count", static_cast<std::uint64_t>(space.opening_count));
    for (const Opening& opening : space.openings) add(opening);
    add(space.centroid_px, space.point, space.bearing);
    add("area_fraction", space.area_fraction);
    add("atmospheric_light", space.atmospheric_light);
    add("darkest_level", static_cast<std::uint64_t>(space.darkest_level));
    add("brightest_level", static_cast<std::uint64_t>(space.brightest_level));
    add("threshold_level", static_cast<std::uint64_t>(space.threshold_level));
    add(space.moments);
    add(space.clusters);
  }

  [[nodiscard]] std::string first_difference(const Bits& other) const {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (fields_[i] != other.fields_[i]) return fields_[i].first;
    }
    return "";
  }

 private:
  void add(const char* name, std::uint64_t bits) { fields_.emplace_back(name, bits); }
  void add(const char* name, double value) { add(name, std::bit_cast<std::uint64_t>(value)); }
  void add(const Pixel& centroid_px, const NormalisedPoint& point, const Bearing& bearing) {
    add("u_px", centroid_px.u_px);
    add("v_px", centroid_px.v_px);
    add("sx", point.sx);
    add("sy", point.sy);
    add("azimuth_rad", bearing.azimuth_rad);
    add("elevation_rad", bearing.elevation_rad);
  }
  void add(const Opening& opening) {
    add(opening.centroid_px, opening.point, opening.bearing);
    add("opening.area_fraction", opening.area_fraction);
    add("opening.confidence", opening.confidence);
  }
  void add(const Moments& moments) {
    add("m00", moments.m00);
    add("m10", moments.m10);
    add("m01", moments.m01);
    add("m20", moments.m20);
    add("m02", moments.m02);
  }
  void add(const Clusters& clusters) {
    add("clusters.count", static_cast<std::uint64_t>(clusters.count));
    add("clusters.cost", clusters.cost);
    add("clusters.iterations", static_cast<std::uint64_t>(clusters.iterations));
    for (std::size_t i = 0; i < clusters.centre.size(); ++i) {
      add("clusters.centre", clusters.centre[i]);
      add("clusters.weight", static_cast<std::uint64_t>(clusters.weight[i]));
      add("clusters.last_level", static_cast<std::uint64_t>(clusters.last_level[i]));
    }
  }

  std::vector<std::pair<std::string, std::uint64_t>> fields_;
};

/// The finder lives on while the targets change under it.
void judge(OpenSpaceFinder& finder, const ImageView& view) {
  std::vector<Bits> answers;
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    answers.emplace_back(finder.find(view));
    ASSERT_EQ(answers.back().first_difference(answers.front()), "")
        << target << " differs from " << supported_cpu_targets().front() << " in this field; " << view.width << " x "
        << view.height << " px";
  }
}

OpenSpaceFinder finder_with(Clustering clustering) {
  FinderConfig config = paper_preset();
  config.clustering = clustering;
  config.grey16_depth_bits = 12;
  return OpenSpaceFinder(config);
}

class SameBits : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(SameBits, OfFramesOfAllContentsAndSizes) {
  OpenSpaceFinder exact = finder_with(Clustering::kExact);
  OpenSpaceFinder lloyd = finder_with(Clustering::kLloyd);
  FinderConfig enclosed = paper_preset();
  enclosed.method = Method::kAdit;
  enclosed.grey16_depth_bits = 12;
  OpenSpaceFinder adit(enclosed);
  const auto judge_all = [&](const Frame& frame) {
    ASSERT_NO_FATAL_FAILURE(judge(adit, frame.view()));
    ASSERT_NO_FATAL_FAILURE(judge(exact, frame.view()));
    ASSERT_NO_FATAL_FAILURE(judge(lloyd, frame.view()));
  };
  for (const Content content : reference::kContents) {
    SCOPED_TRACE(to_string(content));
    ASSERT_NO_FATAL_FAILURE(judge_all(Frame(content, GetParam(), 333, 241, 1, {2, true})));
    ASSERT_NO_FATAL_FAILURE(judge_all(Frame(content, GetParam(), 16, 97, 2)));
    if (judging::grid_is_small()) continue;
    ASSERT_NO_FATAL_FAILURE(judge_all(Frame(content, GetParam(), 640, 480, 3)));
    ASSERT_NO_FATAL_FAILURE(judge_all(Frame(content, GetParam(), 1279, 721, 4, {6, false})));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SameBits, ::testing::ValuesIn(reference::kFormats),
                         [](const auto& format) { return std::string(reference::to_string(format.param)); });

}  // namespace
}  // namespace adit
