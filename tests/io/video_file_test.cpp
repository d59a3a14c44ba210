#include "adit/io/video_file.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using adit::io::OutputError;
using adit::io::VideoFile;
using adit::testing::ScratchFolder;
using Names = std::vector<std::string>;

cv::Mat grey(int width, int height, int level) { return {height, width, CV_8UC3, cv::Scalar::all(level)}; }

TEST(VideoFile, EveryKindPlaysWithAllItsFrames) {
  const ScratchFolder folder;
  for (const char* name : {"v.mp4", "v.mkv", "v.avi"}) {
    const std::string path = (folder / name).string();
    VideoFile video(path, 25.0);
    for (int i = 0; i < 9; ++i) video.write(grey(64, 48, 20 * i));
    EXPECT_FALSE(std::filesystem::exists(path));
    video.commit();
    cv::VideoCapture reader(path, cv::CAP_FFMPEG);
    ASSERT_TRUE(reader.isOpened()) << name;
    EXPECT_NEAR(reader.get(cv::CAP_PROP_FPS), 25.0, 0.01);
    cv::Mat frame;
    for (int i = 0; i < 9; ++i) {
      ASSERT_TRUE(reader.read(frame)) << name << " " << i;
      EXPECT_NEAR(cv::mean(frame)[0], 20 * i, 8) << name << " " << i;
    }
    EXPECT_FALSE(reader.read(frame));
  }
  EXPECT_EQ(folder.names(), (Names{"v.avi", "v.mkv", "v.mp4"}));
}

TEST(VideoFile, OtherSizesAreFittedWithBlackBars) {
  const ScratchFolder folder;
  const std::string path = (folder / "v.avi").string();
  VideoFile video(path, 25.0);
  video.write(grey(63, 47, 200));  // odd: padded
  video.write(grey(32, 96, 200));  // tall: bars left and right
  video.commit();
  cv::VideoCapture reader(path, cv::CAP_FFMPEG);
  cv::Mat frame;
  ASSERT_TRUE(reader.read(frame));
  EXPECT_EQ(frame.size(), cv::Size(64, 48));
  EXPECT_GT(frame.at<cv::Vec3b>(20, 20)[0], 180);
  ASSERT_TRUE(reader.read(frame));
  EXPECT_EQ(frame.size(), cv::Size(64, 48));
  EXPECT_LT(frame.at<cv::Vec3b>(24, 4)[0], 20);
  EXPECT_GT(frame.at<cv::Vec3b>(24, 32)[0], 180);
}

TEST(VideoFile, NothingIsLeftWithoutCommitOrFrames) {
  const ScratchFolder folder;
  {
    VideoFile video(folder / "v.mp4", 25.0);
    video.write(grey(64, 48, 9));
  }
  {
    VideoFile video(folder / "v.mp4", 25.0);
    video.commit();
  }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(VideoFile, UnknownKindsAndPlacesAreRefused) {
  const ScratchFolder folder;
  EXPECT_THROW(VideoFile(folder / "v.gif", 25.0), OutputError);
  EXPECT_THROW(VideoFile(folder / "no/v.mp4", 25.0), OutputError);
  EXPECT_THROW(VideoFile("/dev/null", 25.0), OutputError);
  EXPECT_EQ(folder.names(), Names{});
}

}  // namespace
