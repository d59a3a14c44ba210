// The example of the README, compiled as it stands there, does what it says.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

double yaw_to_open_space_rad(const std::uint8_t* bgr, int width, int height);

namespace {

TEST(Readme, TheExampleTurnsTowardsTheDark) {
  for (const bool is_left : {true, false}) {
    cv::Mat frame(480, 640, CV_8UC3, cv::Scalar(140, 150, 160));
    cv::rectangle(frame, {is_left ? 60 : 440, 160, 140, 140}, cv::Scalar(5, 5, 5), cv::FILLED);
    const double yaw_rad = yaw_to_open_space_rad(frame.data, frame.cols, frame.rows);
    EXPECT_NEAR(yaw_rad, is_left ? 0.40 : -0.40, 0.1);
  }
}

TEST(Readme, TheExampleDoesNotTurnInTheDark) {
  const cv::Mat black(480, 640, CV_8UC3, cv::Scalar::all(0));
  EXPECT_EQ(yaw_to_open_space_rad(black.data, black.cols, black.rows), 0.0);
}

}  // namespace
