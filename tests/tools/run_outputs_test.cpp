#include <gtest/gtest.h>
#include <sys/mount.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using Names = std::vector<std::string>;

TEST(RunOutputs, VideoShowsFrameAndDepthSideBySide) {
  const ScratchFolder folder;
  const std::string clip = make_clip(folder / "c.avi", 8);
  for (const char* name : {"v.mp4", "v.avi"}) {
    const Outcome outcome = run_adit({"run", clip, "--video", (folder / name).string(), "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "") << "no table was asked for";
    cv::VideoCapture video((folder / name).string(), cv::CAP_FFMPEG);
    EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 20.0, 0.01);
    cv::Mat frame;
    int frames = 0;
    while (video.read(frame)) {
      ++frames;
      EXPECT_EQ(frame.size(), cv::Size(640, 240));
    }
    EXPECT_EQ(frames, 8) << name;
  }
}

/// What is drawn is what the table says: pictures of a sequence's stages come from the pilot's own judgement.
TEST(RunOutputs, PicturesDoNotChangeTheTableOfASequence) {
  const ScratchFolder folder;
  const std::string clip = make_clip(folder / "c.avi", 8);
  for (const std::string method : {"paper", "adit"}) {
    const Outcome plain = run_adit({"run", clip, "--method", method, "--csv", "-", "--quiet"});
    const Outcome drawn = run_adit({"run", clip, "--method", method, "--csv", "-", "--quiet", "--video",
                                    (folder / "v.mp4").string(), "--report", (folder / "r.html").string()});
    EXPECT_EQ(plain.exit_code, 0) << plain.err;
    EXPECT_EQ(plain.out, drawn.out);
  }
}

TEST(RunOutputs, FramesAreNumberedAndNamedAfterTheirSource) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 3);
  write_text(folder / "p/frame1.png", "");
  const std::string clip = make_clip(folder / "c.avi", 2);
  const Outcome outcome = run_adit({"run", passages, clip, "--frames", (folder / "o").string(), "--quiet"});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  const std::string out = (folder / "o").string() + "/";
  for (const char* name : {"000000_frame0.png", "000002_frame2.png", "000003_c.png", "000004_c.png"}) {
    EXPECT_EQ(cv::imread(out + name).size(), cv::Size(320, 240)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(out + "000001_frame1.png")) << "there is no picture of it";
}

TEST(RunOutputs, FullDeviceIsTold) {
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  for (const std::string option : {"--csv", "--jsonl"}) {
    const Outcome outcome = run_adit({"run", image, option, "/dev/full"});
    EXPECT_EQ(outcome.exit_code, 6);
    EXPECT_EQ(outcome.err, "adit: /dev/full: cannot be written: No space left on device\n");
  }
}

/// Files may not grow: what a full disk does, without one.
TEST(RunOutputs, OutputThatStopsGrowingLeavesNothing) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 10);
  std::filesystem::create_directory(folder / "o");
  for (const std::vector<std::string>& output : std::vector<std::vector<std::string>>{
           {"--csv", "t.csv"}, {"--jsonl", "t.jsonl"}, {"--video", "v.mp4"}, {"--video", "v.avi"}, {"--frames", "."}}) {
    std::vector<std::string> arguments{"run", passages};
    arguments.insert(arguments.end(), output.begin(), output.end());
    const Outcome outcome = run_adit(arguments, {.folder = folder / "o", .file_bytes_max = 1000});
    EXPECT_EQ(outcome.exit_code, 6) << output[1] << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder / "o")) << output[1];
  }
}

TEST(RunOutputs, FullDiskLeavesNothing) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 10);
  const std::string disk = (folder / "disk").string();
  std::filesystem::create_directory(disk);
  if (::mount("none", disk.c_str(), "tmpfs", 0, "size=16k") != 0) GTEST_SKIP() << "no right to mount a small disk";
  write_text(disk + "/filler", std::string(11000, 'x'));
  for (const std::vector<std::string>& output : std::vector<std::vector<std::string>>{
           {"--csv", "t.csv", "--jsonl", "t.jsonl"}, {"--video", "v.mp4"}, {"--video", "v.avi"}, {"--frames", "."}}) {
    std::vector<std::string> arguments{"run", passages};
    arguments.insert(arguments.end(), output.begin(), output.end());
    const Outcome outcome = run_adit(arguments, {.folder = disk});
    EXPECT_EQ(outcome.exit_code, 6) << output[1] << outcome.err;
    EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << output[1] << outcome.err;
    Names left;
    for (const auto& entry : std::filesystem::directory_iterator(disk)) left.push_back(entry.path().filename());
    EXPECT_EQ(left, Names{"filler"}) << output[1];
  }
  ::umount(disk.c_str());
}

TEST(RunOutputs, PlacesThatCannotBeAreRefusedBeforeTheWork) {
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  for (const char* option : {"--csv", "--jsonl"}) {
    const Outcome outcome = run_adit({"run", image, option, "no/such/folder/t"});
    EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u);
  }
  EXPECT_EQ(run_adit({"run", image, "--video", (folder / "v.gif").string()}).exit_code, 6);
  EXPECT_EQ(run_adit({"run", image, "--frames", image + "/x"}).exit_code, 6);
}

}  // namespace
