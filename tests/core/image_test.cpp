#include "adit/image.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "frames.hpp"

namespace adit {
namespace {

TEST(Image, AFrameIsAccepted) { EXPECT_EQ(fault_of(test::Frame(16, 16, PixelFormat::kBgr8).view()), ""); }

TEST(Image, EveryFormatHasItsSize) {
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kGrey8), 1);
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kBgr8), 3);
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kRgb8), 3);
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kBgra8), 4);
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kRgba8), 4);
  EXPECT_EQ(bytes_per_pixel(PixelFormat::kGrey16), 2);
  EXPECT_EQ(bytes_per_pixel(static_cast<PixelFormat>(99)), 0);
}

TEST(Image, WhatIsNoFrameIsRefusedInWords) {
  const test::Frame frame(64, 48, PixelFormat::kBgr8);
  const auto fault_with = [&frame](auto change) {
    ImageView view = frame.view();
    change(view);
    return std::string(fault_of(view));
  };
  EXPECT_NE(fault_with([](ImageView& v) { v.data = nullptr; }).find("null"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.width = 15; }).find("width"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.width = 8193; }).find("width"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.width = -64; }).find("width"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.height = 15; }).find("height"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.height = std::numeric_limits<int>::max(); }).find("height"),
            std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.stride_bytes = 191; }).find("stride"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.stride_bytes = -191; }).find("stride"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.stride_bytes = 0; }).find("stride"), std::string::npos);
  EXPECT_NE(fault_with([](ImageView& v) { v.format = static_cast<PixelFormat>(6); }).find("format"), std::string::npos);
  EXPECT_EQ(fault_with([](ImageView& v) { v.stride_bytes = std::numeric_limits<std::ptrdiff_t>::min(); }), "");
}

TEST(Image, SixteenBitsMustBeAligned) {
  const test::Frame frame(64, 48, PixelFormat::kGrey16);
  ImageView view = frame.view();
  EXPECT_EQ(fault_of(view), "");
  view.data += 1;
  EXPECT_NE(fault_of(view), "");
  view = frame.view();
  view.stride_bytes += 1;
  EXPECT_NE(fault_of(view), "");
}

TEST(Image, WhatDoesNotLieSideBySideIsAFrameToo) {
  const test::Frame frame(64, 48, PixelFormat::kBgr8), deep(64, 48, PixelFormat::kGrey16);
  ImageView view = frame.view();
  EXPECT_TRUE(view.is_packed());
  view.pixel_stride_bytes = 3;
  view.channel_stride_bytes = 1;
  EXPECT_TRUE(view.is_packed());
  view.stride_bytes = 0;
  EXPECT_EQ(fault_of(view), "") << "one row for all";
  view.pixel_stride_bytes = -3;
  EXPECT_FALSE(view.is_packed());
  EXPECT_EQ(fault_of(view), "") << "one row for all, mirrored";
  view = deep.view();
  view.data += 1;
  EXPECT_NE(fault_of(view), "") << "packed, at an odd address";
  view.pixel_stride_bytes = 2;
  EXPECT_FALSE(view.is_packed());
  EXPECT_EQ(fault_of(view), "") << "said to lie anywhere";
}

}  // namespace
}  // namespace adit
