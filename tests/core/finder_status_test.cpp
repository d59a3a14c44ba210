// Every status has a frame that causes it, and no frame of one grey value is ever found.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "adit/finder.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::Frame;

Status status_of(const Frame& frame, const FinderConfig& config = paper_preset()) {
  return OpenSpaceFinder(config).find(frame.view()).status;
}

TEST(FinderStatus, Found) {
  const Frame frame = test::tunnel({});
  const OpenSpace seen = OpenSpaceFinder(paper_preset()).find(frame.view());
  EXPECT_EQ(seen.status, Status::kFound);
  EXPECT_TRUE(seen.found());
  EXPECT_NEAR(seen.centroid_px.u_px, 60.0, 4.0);
  EXPECT_NEAR(seen.centroid_px.v_px, 50.0, 4.0);
  EXPECT_GT(seen.confidence, 0.5);
  EXPECT_LE(seen.confidence, 1.0);
  ASSERT_EQ(seen.opening_count, 1);
  EXPECT_EQ(seen.openings[0].centroid_px.u_px, seen.centroid_px.u_px);
  EXPECT_EQ(seen.openings[0].bearing.azimuth_rad, seen.bearing.azimuth_rad);
  EXPECT_EQ(seen.openings[0].confidence, seen.confidence);
  EXPECT_LT(seen.bearing.azimuth_rad, 0.0) << "left of the middle";
  EXPECT_GT(seen.bearing.elevation_rad, 0.0) << "above the middle";
  EXPECT_NEAR(seen.point.sx, std::tan(seen.bearing.azimuth_rad), 1e-12);
}

TEST(FinderStatus, TooDark) {
  EXPECT_EQ(status_of(Frame(64, 48, PixelFormat::kBgr8, 0)), Status::kTooDark);
  EXPECT_EQ(status_of(Frame(64, 48, PixelFormat::kGrey16, 0)), Status::kTooDark);
  EXPECT_EQ(status_of(test::tunnel({.darkest = 0, .brightest = 2, .noise = 2})), Status::kTooDark);
}

TEST(FinderStatus, ABlackFrameWithHotPixelsIsTooDark) {
  Frame frame(640, 480, PixelFormat::kBgr8, 1);
  for (int i = 0; i < 40; ++i) std::memset(frame.pixel((i * 131) % 640, (i * 97) % 480), 255, 3);
  const OpenSpace seen = OpenSpaceFinder(paper_preset()).find(frame.view());
  EXPECT_EQ(seen.status, Status::kTooDark);
  EXPECT_LT(seen.atmospheric_light, 6.0);
}

TEST(FinderStatus, TooBright) {
  EXPECT_EQ(status_of(test::tunnel({.darkest = 205, .brightest = 250, .noise = 3})), Status::kTooBright);
  EXPECT_EQ(status_of(Frame(64, 48, PixelFormat::kGrey8, 255)), Status::kTooBright);
}

TEST(FinderStatus, NoContrast) {
  EXPECT_EQ(status_of(Frame(64, 48, PixelFormat::kGrey8, 90)), Status::kNoContrast);
  EXPECT_EQ(status_of(test::tunnel({.darkest = 90, .brightest = 92, .noise = 1})), Status::kNoContrast);
}

TEST(FinderStatus, OneClusterIsNoContrast) {
  // Everything counts for the light, and omega 1 with a high floor: all levels are alike in depth.
  FinderConfig config = paper_preset();
  config.atmospheric_light_fraction = 1.0;
  config.omega = 0.01;
  config.transmission_min = 0.99;
  const Frame frame = test::tunnel({.darkest = 130, .brightest = 140, .noise = 0});
  Frame with_dark_light = frame;
  OpenSpace seen = OpenSpaceFinder(config).find(with_dark_light.view());
  if (seen.clusters.count == 1) {
    EXPECT_EQ(seen.status, Status::kNoContrast);
  }
  config.transmission_min = 0.6;
  config.omega = 1.0;
  seen = OpenSpaceFinder(config).find(frame.view());
  EXPECT_EQ(seen.clusters.count, 1);
  EXPECT_EQ(seen.status, Status::kNoContrast);
}

TEST(FinderStatus, NoRegion) {
  // One speck, larger than the closing mends, smaller than an opening.
  Frame frame(640, 480, PixelFormat::kGrey8, 120);
  for (int v = 200; v < 206; ++v) {
    for (int u = 300; u < 306; ++u) *frame.pixel(u, v) = 10;
  }
  const OpenSpace seen = OpenSpaceFinder(paper_preset()).find(frame.view());
  EXPECT_EQ(seen.status, Status::kNoRegion);
  EXPECT_GT(seen.area_fraction, 0.0);
  EXPECT_LT(seen.area_fraction, 0.002);
}

TEST(FinderStatus, ADeadPixelIsNoOpening) {
  Frame frame(640, 480, PixelFormat::kGrey8, 120);
  *frame.pixel(320, 240) = 0;
  EXPECT_EQ(status_of(frame), Status::kNoRegion);
}

TEST(FinderStatus, BadFrame) {
  OpenSpaceFinder finder(paper_preset());
  EXPECT_EQ(finder.find({}).status, Status::kBadFrame);
  const Frame frame = test::tunnel({});
  ImageView narrow = frame.view();
  narrow.width = 15;
  EXPECT_EQ(finder.find(narrow).status, Status::kBadFrame);
}

TEST(FinderStatus, WrongSize) {
  const Frame frame = test::tunnel({});
  OpenSpaceFinder finder(paper_preset(), Camera(pinhole(161, 120, 75.0)));
  EXPECT_EQ(finder.find(frame.view()).status, Status::kWrongSize);
  OpenSpaceFinder fitting(paper_preset(), Camera(pinhole(160, 120, 75.0)));
  EXPECT_EQ(fitting.find(frame.view()).status, Status::kFound);
}

TEST(FinderStatus, BadComesBeforeWrongSize) {
  OpenSpaceFinder finder(paper_preset(), Camera(pinhole(160, 120, 75.0)));
  EXPECT_EQ(finder.find({}).status, Status::kBadFrame);
}

TEST(FinderStatus, RefusedFramesHaveNothingToFollow) {
  for (const Frame& frame : {Frame(64, 48, PixelFormat::kBgr8, 0), Frame(64, 48, PixelFormat::kGrey8, 90),
                             Frame(64, 48, PixelFormat::kGrey8, 250)}) {
    const OpenSpace seen = OpenSpaceFinder(paper_preset()).find(frame.view());
    EXPECT_FALSE(seen.found());
    EXPECT_EQ(seen.confidence, 0.0);
    EXPECT_EQ(seen.opening_count, 0);
    EXPECT_EQ(seen.bearing.azimuth_rad, 0.0);
    EXPECT_EQ(seen.point.sx, 0.0);
    EXPECT_TRUE(std::isfinite(seen.centroid_px.u_px));
  }
}

TEST(FinderStatus, OneGreyValueIsNeverFound) {
  for (const auto clustering : {Clustering::kExact, Clustering::kLloyd}) {
    FinderConfig config = paper_preset();
    config.clustering = clustering;
    config.too_dark_light_max = 0.0;
    config.too_bright_level_min = 256;
    config.contrast_levels_min = 1;
    config.area_fraction_min = 0.0;
    OpenSpaceFinder lenient(config);
    OpenSpaceFinder finder(paper_preset());
    for (const auto format : {PixelFormat::kGrey8, PixelFormat::kBgr8, PixelFormat::kRgb8, PixelFormat::kBgra8,
                              PixelFormat::kRgba8, PixelFormat::kGrey16}) {
      for (int level = 0; level < 256; ++level) {
        const Frame frame(33, 17, format, level);
        EXPECT_FALSE(finder.find(frame.view()).found()) << level;
        EXPECT_FALSE(lenient.find(frame.view()).found()) << level;
      }
    }
  }
}

TEST(FinderStatus, OneColourIsNeverFound) {
  Frame frame(64, 48, PixelFormat::kBgr8);
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      frame.pixel(u, v)[0] = 20;
      frame.pixel(u, v)[1] = 130;
      frame.pixel(u, v)[2] = 255;
    }
  }
  EXPECT_EQ(status_of(frame), Status::kNoContrast);
}

TEST(FinderStatus, WhateverTheNoiseTheNumbersAreNumbers) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const auto format = static_cast<PixelFormat>(seed % 6);
    const Frame frame = test::noise(16 + static_cast<int>(seed), 16 + static_cast<int>(seed * 7 % 50), format, seed);
    FinderConfig config = paper_preset();
    config.patch_size_px = 1 + 2 * static_cast<int>(seed % 9);
    config.structuring_element_size_px = 1 + 2 * static_cast<int>(seed % 5);
    config.omega = 0.01 + 0.01 * seed;
    config.clustering = seed % 2 == 0 ? Clustering::kExact : Clustering::kLloyd;
    const OpenSpace seen = OpenSpaceFinder(config).find(frame.view());
    for (const double number :
         {seen.confidence, seen.centroid_px.u_px, seen.centroid_px.v_px, seen.point.sx, seen.point.sy,
          seen.bearing.azimuth_rad, seen.bearing.elevation_rad, seen.area_fraction, seen.atmospheric_light}) {
      EXPECT_TRUE(std::isfinite(number)) << "seed " << seed;
    }
    EXPECT_TRUE(seen.confidence >= 0.0 && seen.confidence <= 1.0);
    EXPECT_TRUE(seen.area_fraction >= 0.0 && seen.area_fraction <= 1.0);
    EXPECT_TRUE(seen.atmospheric_light >= 0.0 && seen.atmospheric_light <= 255.0);
  }
}

}  // namespace
}  // namespace adit
