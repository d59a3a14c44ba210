#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "adit/io/image_file.hpp"
#include "drawn_tunnel.hpp"

namespace adit::drawn {
namespace {

TEST(Clip, IsDrawnTheSameEachTime) {
  const cv::Mat once = tunnel_frame(45, 48, 36), again = tunnel_frame(45, 48, 36);
  EXPECT_EQ(cv::norm(once, again, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(once, tunnel_frame(46, 48, 36), cv::NORM_INF), 0.0);
}

TEST(Clip, TheStillIsTheDrawnFrame) {
  const cv::Mat still = io::read_image(ADIT_SOURCE_DIR "/data/tunnel.jpg");
  ASSERT_EQ(still.size(), cv::Size(kWidth_px, kHeight_px));
  cv::Mat small, drawn;
  cv::resize(still, small, {16, 12}, 0, 0, cv::INTER_AREA);
  cv::resize(tunnel_frame(45, 128, 96), drawn, {16, 12}, 0, 0, cv::INTER_AREA);
  EXPECT_LT(cv::norm(small, drawn, cv::NORM_L1) / (16.0 * 12.0 * 3.0), 6.0);
}

TEST(Clip, TheFileHasAllItsFrames) {
  cv::VideoCapture clip(ADIT_SOURCE_DIR "/data/clip.avi");
  ASSERT_TRUE(clip.isOpened());
  EXPECT_NEAR(clip.get(cv::CAP_PROP_FPS), kRate_hz, 0.01);
  int frames = 0;
  for (cv::Mat frame; clip.read(frame); ++frames) {
    ASSERT_EQ(frame.size(), cv::Size(kWidth_px / 2, kHeight_px / 2));
  }
  EXPECT_EQ(frames, kFrameCount);
}

}  // namespace
}  // namespace adit::drawn
