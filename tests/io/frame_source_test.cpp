#include "adit/io/frame_source.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/errors.hpp"
#include "adit/io/video_file.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::io;
using adit::testing::message_of;
using adit::testing::ScratchFolder;
using adit::testing::truncate_copy;
using adit::testing::write_text;

std::string make_image(const std::filesystem::path& path, int level = 50) {
  EXPECT_TRUE(cv::imwrite(path.string(), cv::Mat(24, 32, CV_8UC3, cv::Scalar::all(level))));
  return path.string();
}

std::string make_video(const std::filesystem::path& path, int frames, double rate_hz) {
  VideoFile video(path, rate_hz);
  for (int i = 0; i < frames; ++i) video.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(20 + i)));
  video.commit();
  return path.string();
}

std::vector<Frame> all_frames(FrameSource& source) {
  std::vector<Frame> frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return frames;
}

TEST(FrameSource, ImagesInARowMakeOneSource) {
  const ScratchFolder folder;
  const std::string a = make_image(folder / "a.png", 10);
  const std::string b = make_image(folder / "b.png", 20);
  const auto sources = open_sources({b, a}, {.images_hz = 10.0});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_FALSE(sources[0]->is_sequence());
  EXPECT_EQ(sources[0]->frame_count(), 2);
  auto frames = all_frames(*sources[0]);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].source, b);
  EXPECT_EQ(frames[1].source, a);
  EXPECT_EQ(frames[1].index, 1);
  EXPECT_DOUBLE_EQ(frames[1].stamp_s, 0.1);
  EXPECT_TRUE(frames[1].pixels.empty());
  load_pixels(frames[1]);
  EXPECT_EQ(frames[1].pixels.at<cv::Vec3b>(3, 3)[1], 10);
}

TEST(FrameSource, InputsKeepTheirOrder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "run");
  make_image(folder / "run/f10.png");
  make_image(folder / "run/f9.png");
  const std::string single = make_image(folder / "z.png");
  const std::string video = make_video(folder / "v.avi", 3, 25.0);
  const auto sources = open_sources({video, single, (folder / "run").string(), (folder / "run/f?.png").string()}, {});
  ASSERT_EQ(sources.size(), 4u);
  EXPECT_TRUE(sources[0]->is_sequence());
  EXPECT_EQ(all_frames(*sources[1])[0].source, single);
  EXPECT_EQ(all_frames(*sources[2])[0].source, (folder / "run/f9.png").string());
  EXPECT_EQ(sources[3]->frame_count(), 1);
}

TEST(FrameSource, ImagesBecomeASequenceOnRequest) {
  const ScratchFolder folder;
  const std::string a = make_image(folder / "a.png");
  EXPECT_TRUE(open_sources({a}, {.images_are_sequence = true})[0]->is_sequence());
}

TEST(FrameSource, UnreadableImageSaysWhyAndTheNextComes) {
  const ScratchFolder folder;
  const std::string a = make_image(folder / "a.png");
  const std::string cut = truncate_copy(a, folder / "cut.png", 0.5).string();
  const auto sources = open_sources({cut, a}, {});
  auto frames = all_frames(*sources[0]);
  load_pixels(frames[0]);
  load_pixels(frames[1]);
  EXPECT_TRUE(frames[0].fault.starts_with(cut + ": ")) << frames[0].fault;
  EXPECT_TRUE(frames[1].fault.empty());
  EXPECT_FALSE(frames[1].pixels.empty());
}

TEST(FrameSource, VideoHasItsOwnClock) {
  const ScratchFolder folder;
  for (const char* name : {"v.avi", "v.mp4", "v.mkv"}) {
    const auto sources = open_sources({make_video(folder / name, 7, 20.0)}, {.images_hz = 5.0});
    const auto frames = all_frames(*sources[0]);
    ASSERT_EQ(frames.size(), 7u) << name;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i].index, static_cast<std::int64_t>(i));
      EXPECT_NEAR(frames[i].stamp_s, static_cast<double>(i) / 20.0, 0.002) << name;
    }
    EXPECT_NEAR(frames[6].pixels.at<cv::Vec3b>(20, 20)[1], 26, 3) << name;
    EXPECT_NEAR(sources[0]->rate_hz(), 20.0, 0.01);
    EXPECT_EQ(sources[0]->fault(), "");
  }
}

TEST(FrameSource, TruncatedVideoIsTold) {
  const ScratchFolder folder;
  const std::string whole = make_video(folder / "v.avi", 60, 30.0);
  const std::string cut = truncate_copy(whole, folder / "cut.avi", 0.6).string();
  const auto sources = open_sources({cut}, {});
  const auto frames = all_frames(*sources[0]);
  EXPECT_GT(frames.size(), 10u);
  EXPECT_LT(frames.size(), 50u);
  EXPECT_TRUE(sources[0]->fault().starts_with(cut + ": ")) << sources[0]->fault();
  // An mp4 without its end has no index at all.
  const std::string mp4 = make_video(folder / "v.mp4", 20, 30.0);
  const std::string cut_mp4 = truncate_copy(mp4, folder / "cut.mp4", 0.5).string();
  EXPECT_THROW((void)open_sources({cut_mp4}, {}), InputError);
}

TEST(FrameSource, EachFaultHasItsReason) {
  const ScratchFolder folder;
  const auto why = [](const std::string& input) {
    return message_of<InputError>([&] { (void)open_sources({input}, {}); });
  };
  const std::string none = (folder / "none.png").string();
  EXPECT_EQ(why(none), none + ": no such file");
  EXPECT_NE(why(folder.path().string()).find("no images in this folder"), std::string::npos);
  EXPECT_NE(why((folder / "*.png").string()).find("no file matches"), std::string::npos);
  EXPECT_NE(why("/dev/video731").find("no such camera"), std::string::npos);
  EXPECT_NE(why(write_text(folder / "notes.txt", "Dear diary,\nno picture today.\n").string()).find("neither"),
            std::string::npos);
  EXPECT_NE(why(write_text(folder / "e.mp4", "").string()).find("empty"), std::string::npos);
  EXPECT_NE(why(write_text(folder / "x.mp4", std::string(5000, '\3')).string()).find("neither"), std::string::npos);
}

}  // namespace
