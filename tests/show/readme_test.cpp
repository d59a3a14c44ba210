// The example of the README, compiled as it stands there, does what it says.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

double yaw_rate_rad_s(const std::uint8_t* bgr, int width, int height, double stamp_s);

namespace {

/// The example remembers its last command: stamps go on from one test to the next.
double settled_rate_rad_s(const cv::Mat& frame) {
  static double stamp_s = 0.0;
  double rate_rad_s = 0.0;
  for (int i = 0; i < 30; ++i) rate_rad_s = yaw_rate_rad_s(frame.data, frame.cols, frame.rows, stamp_s += 0.1);
  return rate_rad_s;
}

TEST(Readme, TheExampleTurnsTowardsTheDark) {
  for (const bool is_left : {true, false}) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(140, 150, 160));
    cv::rectangle(frame, {is_left ? 60 : 440, 160, 140, 140}, cv::Scalar(5, 5, 5), cv::FILLED);
    EXPECT_NEAR(settled_rate_rad_s(frame), is_left ? 0.40 : -0.40, 0.1);
  }
}

TEST(Readme, TheExampleDoesNotTurnInTheDark) {
  EXPECT_EQ(settled_rate_rad_s(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(0))), 0.0);
}

}  // namespace
