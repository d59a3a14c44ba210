#include "adit/io/draw.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace adit::io {
namespace {

OpenSpace found_at(double u_px, double v_px) {
  OpenSpace seen;
  seen.status = Status::kFound;
  seen.confidence = 0.5;
  seen.centroid_px = {u_px, v_px};
  return seen;
}

StageImages stages_of(int width, int height) {
  StageImages stages;
  stages.width = width;
  stages.height = height;
  for (int i = 0; i < width * height; ++i) stages.closing.push_back(static_cast<float>(i % width));
  return stages;
}

bool is_red(const cv::Vec3b& pixel) { return pixel[2] > 150 && pixel[1] < 90 && pixel[0] < 90; }
bool is_green(const cv::Vec3b& pixel) { return pixel[1] > 180 && pixel[2] < 140 && pixel[0] < 140; }

template <class Wanted>
int count(const cv::Mat& bgr, Wanted&& wanted) {
  int pixels = 0;
  for (int v = 0; v < bgr.rows; ++v) {
    for (int u = 0; u < bgr.cols; ++u) pixels += wanted(bgr.at<cv::Vec3b>(v, u)) ? 1 : 0;
  }
  return pixels;
}

TEST(Draw, TheCircleIsRoundTheCentroid) {
  cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(60, 60, 60));
  draw_overlay(frame, found_at(200, 300), std::nullopt);
  cv::Moments red;
  cv::Mat mask(frame.size(), CV_8U);
  for (int v = 0; v < frame.rows; ++v) {
    for (int u = 0; u < frame.cols; ++u) mask.at<std::uint8_t>(v, u) = is_red(frame.at<cv::Vec3b>(v, u)) ? 255 : 0;
  }
  red = cv::moments(mask, true);
  ASSERT_GT(red.m00, 50.0);
  EXPECT_NEAR(red.m10 / red.m00, 200.0, 0.5);
  EXPECT_NEAR(red.m01 / red.m00, 300.0, 0.5);
}

TEST(Draw, WithoutAnOpeningThereIsABannerAndNoCircle) {
  for (int status = 1; status < kStatusCount; ++status) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(60, 60, 60));
    OpenSpace seen = found_at(200, 300);
    seen.status = static_cast<Status>(status);
    draw_overlay(frame, seen, std::nullopt);
    EXPECT_EQ(count(frame.rowRange(100, 480), is_red), 0) << to_string(seen.status);
    const cv::Mat banner = frame.rowRange(0, 20);
    EXPECT_GT(count(banner, [](const cv::Vec3b& p) { return p[2] > 120 && p[0] < 60; }), 640 * 8);
    EXPECT_GT(count(banner, [](const cv::Vec3b& p) { return p[0] > 220 && p[1] > 220; }), 100) << "no words";
  }
}

TEST(Draw, TheArrowPointsWhereTheVehicleTurns) {
  for (const double rate : {0.5, -0.5}) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(60, 60, 60));
    draw_overlay(frame, found_at(320, 200), HeadingCommand{HeadingState::kSteer, rate});
    const int left = count(frame.colRange(0, 310), is_green), right = count(frame.colRange(330, 640), is_green);
    EXPECT_GT(rate > 0.0 ? left : right, 200);
    EXPECT_EQ(rate > 0.0 ? right : left, 0);
  }
}

TEST(Draw, NothingTurnsNothingIsGreen) {
  cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(60, 60, 60));
  draw_overlay(frame, found_at(320, 200), HeadingCommand{HeadingState::kHold, 0.0});
  EXPECT_EQ(count(frame, is_green), 0);
}

TEST(Draw, EveryFrameCanBeDrawnOn) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1}) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(16, 16), cv::Size(17, 23), cv::Size(97, 49),
                                cv::Size(160, 120), cv::Size(16, 700), cv::Size(900, 16), cv::Size(3840, 2160)}) {
      if (size.width > 1000 && type != CV_8UC3) continue;
      const cv::Mat frame(size, type, cv::Scalar::all(100));
      const cv::Mat before = frame.clone();
      OpenSpace seen = found_at(size.width - 1.0, size.height - 1.0);
      const StageImages stages = stages_of(size.width, size.height);
      for (const Status status : {Status::kFound, Status::kTooDark}) {
        seen.status = status;
        const cv::Mat both = side_by_side(frame, seen, stages, HeadingCommand{HeadingState::kSteer, -0.3});
        EXPECT_EQ(both.type(), CV_8UC3);
        EXPECT_EQ(both.size(), cv::Size(2 * size.width, size.height));
      }
      EXPECT_EQ(cv::norm(frame, before, cv::NORM_INF), 0.0) << "the caller's frame was drawn on";
    }
  }
}

TEST(Draw, LettersGrowWithTheFrame) {
  int last = 0;
  for (const int width : {160, 640, 3840}) {
    cv::Mat frame(width * 9 / 16, width, CV_8UC3, cv::Scalar(60, 60, 60));
    draw_overlay(frame, found_at(-1000, -1000), std::nullopt);
    int rows = 0;
    for (int v = 0; v < frame.rows; ++v) {
      rows += count(frame.row(v), [](const cv::Vec3b& p) { return p[0] > 200 && p[2] > 200; }) > 0 ? 1 : 0;
    }
    EXPECT_GT(rows, last);
    EXPECT_GE(rows, 6) << "not legible at " << width << " px";
    last = rows;
  }
}

TEST(Draw, DarkIsFar) {
  const cv::Mat map = depth_map(stages_of(64, 8));
  const auto brightness = [&](int u) {
    const auto pixel = map.at<cv::Vec3b>(4, u);
    return pixel[0] + pixel[1] + pixel[2];
  };
  EXPECT_LT(brightness(0), 30);
  for (int u = 1; u < 64; ++u) EXPECT_GE(brightness(u) + 12, brightness(u - 1)) << u;
  EXPECT_GT(brightness(63), 500);
}

TEST(Draw, NoDepthIsEvenGrey) {
  StageImages none;
  const cv::Mat both = side_by_side(cv::Mat(48, 64, CV_8UC1, cv::Scalar(9)), OpenSpace(), none, std::nullopt);
  EXPECT_EQ(both.size(), cv::Size(128, 48));
  EXPECT_EQ(both.at<cv::Vec3b>(40, 100), cv::Vec3b(64, 64, 64));
}

TEST(Draw, SixteenBitsAreCutAsTheFinderCutsThem) {
  cv::Mat grey(1, 4, CV_16UC1);
  grey.at<std::uint16_t>(0, 0) = 0;
  grey.at<std::uint16_t>(0, 1) = 1023;
  grey.at<std::uint16_t>(0, 2) = 511;
  grey.at<std::uint16_t>(0, 3) = 4095;
  const cv::Mat bgr = bgr_of(grey, 10);
  EXPECT_EQ(bgr.at<cv::Vec3b>(0, 0)[0], 0);
  EXPECT_EQ(bgr.at<cv::Vec3b>(0, 1)[1], 255);
  EXPECT_EQ(bgr.at<cv::Vec3b>(0, 2)[2], 127);
  EXPECT_EQ(bgr.at<cv::Vec3b>(0, 3)[0], 255);
}

TEST(Draw, WhatIsNoPictureIsRefused) {
  cv::Mat grey(48, 64, CV_8UC1), empty;
  EXPECT_THROW(draw_overlay(grey, OpenSpace(), std::nullopt), std::invalid_argument);
  EXPECT_THROW(draw_overlay(empty, OpenSpace(), std::nullopt), std::invalid_argument);
  EXPECT_THROW((void)bgr_of(empty), std::invalid_argument);
  EXPECT_THROW((void)bgr_of(cv::Mat(4, 4, CV_32FC1)), std::invalid_argument);
  EXPECT_THROW((void)bgr_of(cv::Mat(4, 4, CV_16UC1), 7), std::invalid_argument);
  EXPECT_THROW((void)side_by_side(cv::Mat(48, 64, CV_8UC3), OpenSpace(), stages_of(64, 47), std::nullopt),
               std::invalid_argument);
}

}  // namespace
}  // namespace adit::io
