#include <gtest/gtest.h>

#include <stdexcept>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::Frame;

TEST(FinderSizes, SmallAndOddFramesAreJudged) {
  OpenSpaceFinder finder(paper_preset());
  for (int width = 16; width < 40; width += 3) {
    for (int height = 16; height < 40; height += 5) {
      const Frame frame = test::tunnel({.width = width, .height = height, .u_px = 0.5 * width, .v_px = 0.5 * height});
      const OpenSpace seen = finder.find(frame.view());
      EXPECT_EQ(seen.status, Status::kFound) << width << " x " << height;
      EXPECT_NEAR(seen.centroid_px.u_px, 0.5 * width, 0.2 * width);
      EXPECT_NEAR(seen.centroid_px.v_px, 0.5 * height, 0.2 * height);
    }
  }
}

TEST(FinderSizes, VeryWideAndVeryTallFrames) {
  OpenSpaceFinder finder(paper_preset());
  for (const auto& [width, height] : {std::pair{8192, 16}, {16, 8192}, {4097, 31}}) {
    const Frame frame = test::tunnel({.width = width, .height = height, .u_px = 0.3 * width, .v_px = 0.5 * height});
    const OpenSpace seen = finder.find(frame.view());
    EXPECT_EQ(seen.status, Status::kFound);
    EXPECT_NEAR(seen.centroid_px.u_px, 0.3 * width, 0.1 * width);
  }
}

TEST(FinderSizes, ElementsLargerThanTheFrameLeaveNoContrast) {
  FinderConfig config = paper_preset();
  config.patch_size_px = 1023;
  config.structuring_element_size_px = 1023;
  EXPECT_EQ(OpenSpaceFinder(config)
                .find(test::tunnel({.width = 40, .height = 30, .u_px = 20, .v_px = 15, .darkest = 20}).view())
                .status,
            Status::kNoContrast);
}

TEST(FinderSizes, TheLargestFrame) {
  // Flat but for one large square, so that the answer is known: no noise, no random numbers for 67 million pixels.
  FinderConfig config = paper_preset();
  config.patch_size_px = 15;
  config.structuring_element_size_px = 15;
  Frame frame(kSideMax_px, kSideMax_px, PixelFormat::kGrey8, 150);
  for (int v = 3000; v < 5001; ++v) std::fill_n(frame.pixel(1000, v), 2001, std::uint8_t{20});
  const OpenSpace seen = OpenSpaceFinder(config).find(frame.view());
  EXPECT_EQ(seen.status, Status::kFound);
  EXPECT_NEAR(seen.centroid_px.u_px, 2000.0, 1e-9);
  EXPECT_NEAR(seen.centroid_px.v_px, 4000.0, 1e-9);
  // The patch widens the dark square by its radius, the round element blunts its four corners.
  EXPECT_LT(seen.moments.m00, 2015u * 2015u);
  EXPECT_GT(seen.moments.m00, 2015u * 2015u - 100u);
}

TEST(FinderSizes, ReserveRefusesWhatIsNoFrame) {
  OpenSpaceFinder finder(paper_preset());
  EXPECT_THROW(finder.reserve(15, 480), std::invalid_argument);
  EXPECT_THROW(finder.reserve(640, 8193), std::invalid_argument);
  EXPECT_THROW(finder.reserve(-1, -1), std::invalid_argument);
  finder.reserve(640, 480);
}

TEST(FinderSizes, TheCameraGivesTheBearing) {
  const Frame frame = test::tunnel({.width = 160, .height = 120, .u_px = 100, .v_px = 60});
  CameraModel model = pinhole(160, 120, 75.0);
  model.principal_point_x_px = 100.0;
  OpenSpaceFinder finder(paper_preset(), Camera(model));
  const OpenSpace seen = finder.find(frame.view());
  EXPECT_NEAR(seen.point.sx, (seen.centroid_px.u_px - 100.0) / model.focal_length_x_px, 1e-12);
  FinderConfig narrow = paper_preset();
  narrow.assumed_hfov_deg = 40.0;
  EXPECT_LT(OpenSpaceFinder(narrow).find(frame.view()).point.sx,
            OpenSpaceFinder(paper_preset()).find(frame.view()).point.sx);
}

}  // namespace
}  // namespace adit
