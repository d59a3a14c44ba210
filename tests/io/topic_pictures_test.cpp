#include "adit/io/topic_pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace adit::io {
namespace {

constexpr int kWidth = 160, kHeight = 120;

OpenSpace ahead() {
  OpenSpace o;
  o.status = Status::kFound;
  o.centroid_px = {80.0, 60.0};
  return o;
}

ImageView view_of(const cv::Mat& m, PixelFormat format) {
  return {m.data, m.cols, m.rows, static_cast<std::ptrdiff_t>(m.step), format};
}

/// Blue on the left, green on the right, in BGR.
cv::Mat colours() {
  cv::Mat bgr(kHeight, kWidth, CV_8UC3, cv::Scalar(200, 40, 10));
  bgr.colRange(kWidth / 2, kWidth).setTo(cv::Scalar(10, 180, 30));
  return bgr;
}

TEST(TopicPicturesTest, TheOrderOfColoursDoesNotShowInTheOverlay) {
  const cv::Mat bgr = colours();
  const cv::Mat expected = overlay_of(view_of(bgr, PixelFormat::kBgr8), ahead(), {}, 16);
  ASSERT_EQ(expected.type(), CV_8UC3);
  const struct {
    int conversion;
    PixelFormat format;
  } kOrders[] = {{cv::COLOR_BGR2RGB, PixelFormat::kRgb8},
                 {cv::COLOR_BGR2BGRA, PixelFormat::kBgra8},
                 {cv::COLOR_BGR2RGBA, PixelFormat::kRgba8}};
  for (const auto& order : kOrders) {
    cv::Mat turned;
    cv::cvtColor(bgr, turned, order.conversion);
    const cv::Mat before = turned.clone();
    const cv::Mat drawn = overlay_of(view_of(turned, order.format), ahead(), {}, 16);
    EXPECT_EQ(cv::norm(drawn, expected, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(turned, before, cv::NORM_INF), 0.0) << "the message's pixels are not drawn on";
  }
}

TEST(TopicPicturesTest, TheCircleIsRed) {
  const cv::Mat grey(kHeight, kWidth, CV_8UC1, cv::Scalar(90));
  const cv::Mat drawn = overlay_of(view_of(grey, PixelFormat::kGrey8), ahead(), {}, 16);
  const cv::Mat around = drawn(cv::Rect(60, 40, 40, 40));
  int red = 0;
  for (int v = 0; v < around.rows; ++v)
    for (int u = 0; u < around.cols; ++u) {
      const auto& p = around.at<cv::Vec3b>(v, u);
      red += p[2] > 200 && p[0] < 100 && p[1] < 100;
    }
  EXPECT_GT(red, 10);
}

TEST(TopicPicturesTest, RowsMayBePadded) {
  const cv::Mat wide(kHeight, kWidth + 24, CV_8UC1, cv::Scalar(90));
  const cv::Mat inside = wide.colRange(0, kWidth);
  const cv::Mat drawn = overlay_of(view_of(inside, PixelFormat::kGrey8), ahead(), {}, 16);
  EXPECT_EQ(drawn.cols, kWidth);
  EXPECT_EQ(drawn.rows, kHeight);
}

TEST(TopicPicturesTest, SixteenBitsAreShownByTheirDepth) {
  const cv::Mat deep(kHeight, kWidth, CV_16UC1, cv::Scalar(2048));
  const cv::Mat drawn = overlay_of(view_of(deep, PixelFormat::kGrey16), ahead(), {}, 12);
  EXPECT_EQ(drawn.at<cv::Vec3b>(30, 20)[1], 128);
}

TEST(TopicPicturesTest, FarIsBlackAndTheFloorOfTheTransmissionIsWhite) {
  FinderConfig config;
  const auto deepest = static_cast<float>(-std::log(config.transmission_min) / config.scattering_coefficient);
  StageImages stages;
  stages.width = 3;
  stages.height = 2;
  stages.closing = {0.0F, deepest, 0.5F * deepest, 2.0F * deepest, -1.0F, 0.25F * deepest};
  const cv::Mat levels = scattering_depth_levels(stages, config);
  ASSERT_EQ(levels.size(), cv::Size(3, 2));
  ASSERT_EQ(levels.type(), CV_8UC1);
  const int expected[] = {0, 255, 128, 255, 0, 64};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(levels.at<std::uint8_t>(i / 3, i % 3), expected[i], 1) << i;
}

}  // namespace
}  // namespace adit::io
