#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using Names = std::vector<std::string>;

/// Nothing can be done: one line that names the file, its exit code, nothing on the disk.
void expect_refused(const std::string& input, int exit_code, const std::string& reason) {
  const ScratchFolder outputs;
  const Outcome outcome = run_adit({"run", input, "--csv", (outputs / "t.csv").string(), "--video",
                                    (outputs / "v.mp4").string(), "--jsonl", (outputs / "t.jsonl").string()});
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("adit: " + input + ": ")) << outcome.err;
  EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  EXPECT_EQ(outputs.names(), Names{});
}

TEST(RunFaults, InputsThatCannotBeRead) {
  const ScratchFolder folder;
  const std::string whole = make_passage(folder / "a.png");
  const std::string jpeg = make_passage(folder / "a.jpg");
  const std::string clip = make_clip(folder / "c.mp4", 10);
  std::filesystem::create_directory(folder / "empty");
  expect_refused((folder / "none.png").string(), 4, "no such file");
  expect_refused((folder / "none").string(), 4, "no such file");
  expect_refused((folder / "empty").string(), 4, "no images in this folder");
  expect_refused((folder / "*.bmp").string(), 4, "no file matches");
  expect_refused("/dev/video731", 4, "no such camera");
  expect_refused(write_text(folder / "e.png", "").string(), 4, "the file is empty");
  expect_refused(write_text(folder / "e.mp4", "").string(), 4, "the file is empty");
  expect_refused(truncate_copy(whole, folder / "cut.png", 0.5).string(), 4, "truncated");
  expect_refused(truncate_copy(jpeg, folder / "cut.jpg", 0.5).string(), 4, "truncated");
  expect_refused(truncate_copy(clip, folder / "cut.mp4", 0.5).string(), 4, "truncated");
  expect_refused(write_text(folder / "t.png", "no picture").string(), 4, "not an image");
  expect_refused(write_text(folder / "t.txt", "no picture").string(), 4, "neither an image nor a video");
}

TEST(RunFaults, StandardOutputStaysEmptyWhenNothingCouldBeRead) {
  const ScratchFolder folder;
  EXPECT_EQ(run_adit({"run", write_text(folder / "e.png", "").string()}).out, "");
}

TEST(RunFaults, OneUnreadableFrameIsToldAndCountedAndTheRestGoesOn) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 5);
  truncate_copy(passages + "/frame2.png", folder / "cut", 0.5);
  std::filesystem::rename(folder / "cut", passages + "/frame2.png");
  const Outcome outcome = run_adit({"run", passages});
  EXPECT_EQ(outcome.exit_code, 5);
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[3][3], "unreadable");
  EXPECT_EQ(rows[3][4], "");
  EXPECT_EQ(rows[4][3], "found");
  const auto said = lines_of(outcome.err);
  ASSERT_EQ(said.size(), 2u) << outcome.err;
  EXPECT_TRUE(said[0].starts_with("adit: " + passages + "/frame2.png: ")) << said[0];
  EXPECT_NE(said[1].find("5 frames: 4 found, 1 unreadable"), std::string::npos) << said[1];
}

TEST(RunFaults, VideoThatBreaksOffIsTold) {
  const ScratchFolder folder;
  const std::string cut = truncate_copy(make_clip(folder / "c.avi", 40), folder / "cut.avi", 0.6).string();
  const Outcome outcome = run_adit({"run", cut});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_NE(outcome.err.find(cut + ": the video ends after "), std::string::npos) << outcome.err;
  EXPECT_GT(lines_of(outcome.out).size(), 10u);
}

TEST(RunFaults, ConfigurationsAndCalibrations) {
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  const auto refused = [&](const std::string& option, const std::string& value, const std::string& begin) {
    const Outcome outcome = run_adit({"run", image, option, value});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("adit: " + begin)) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  const std::string bad = write_text(folder / "b.yaml", "finder:\n  omega: 1.5\n").string();
  refused("--config", bad, bad + ":2: omega: 1.5 is out of range");
  refused("--config", "none.yaml", "none.yaml: no such file");
  refused("--set", "omega=x", "--set omega=x: omega: 'x' is not a number");
  const Outcome unknown = run_adit({"run", image, "--set", "nosuch=1"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_LT(unknown.err.size(), 250u) << "the nearest few, not all";
  EXPECT_NE(unknown.err.find("'adit config'"), std::string::npos) << unknown.err;
  refused("--camera", bad, bad + ":1: image_width: missing");
  refused("--camera", "none.yaml", "none.yaml: no such file");
}

TEST(RunFaults, ALampThatWasNotLearntIsNoSuccess) {
  const ScratchFolder folder;
  const Outcome outcome =
      run_adit({"run", make_passage(folder / "a.png"), "--learn-lamp", "lamp.yaml"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
  EXPECT_NE(outcome.err.find("lamp.yaml: not written"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "lamp.yaml"));
}

TEST(RunFaults, NobodyButAditSpeaks) {
  const ScratchFolder folder;
  const std::string cut = truncate_copy(make_clip(folder / "c.avi", 20), folder / "cut.avi", 0.02).string();
  const Outcome outcome = run_adit({"run", cut});
  EXPECT_NE(outcome.exit_code, 0);
  for (const std::string& line : lines_of(outcome.err))
    EXPECT_TRUE(line.starts_with("adit: ") || line.find(" frames") != std::string::npos) << line;
}

TEST(RunFaults, CameraOfAnotherSizeIsToldOnce) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 3);
  const std::string camera =
      write_text(folder / "cam.yaml",
                 "image_width: 640\nimage_height: 480\ncamera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 500, "
                 "240, 0, 0, 1]}\ndistortion_model: none\n")
          .string();
  const Outcome outcome = run_adit({"run", passages, "--camera", camera});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("320x240 px, but the camera was calibrated at 640x480 px"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("calibrated"), outcome.err.rfind("calibrated"));
  make_passage(passages + "/frame1.png", 300, 200, 640, 480);
  const Outcome mixed = run_adit({"run", passages, "--camera", camera});
  EXPECT_EQ(mixed.exit_code, 5);
  EXPECT_EQ(rows_of(mixed.out)[1][3], "wrong_size");
  EXPECT_EQ(rows_of(mixed.out)[2][3], "found");
}

TEST(RunFaults, FrameThatIsTooSmall) {
  const ScratchFolder folder;
  const std::string tiny = make_passage(folder / "tiny.png", 5, 5, 12, 12);
  const std::string good = make_passage(folder / "good.png");
  EXPECT_EQ(run_adit({"run", tiny}).exit_code, 4);
  const Outcome outcome = run_adit({"run", tiny, good});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_EQ(rows_of(outcome.out)[1][3], "bad_frame");
}

TEST(RunFaults, SixteenBitFrameOfASensorWithFewerBitsIsToldOnce) {
  const ScratchFolder folder;
  const cv::Mat grey = cv::imread(make_passage(folder / "a.png"), cv::IMREAD_GRAYSCALE);
  cv::Mat grey12;
  grey.convertTo(grey12, CV_16U, 16.0);
  const std::string first = (folder / "12.png").string(), second = (folder / "12b.png").string();
  cv::imwrite(first, grey12);
  cv::imwrite(second, grey12);
  const Outcome doubted = run_adit({"run", first, second});
  const std::string advice = "if the sensor has 12 bits, --set grey16_depth_bits=12";
  EXPECT_EQ(doubted.exit_code, 0);
  EXPECT_NE(doubted.err.find("adit: " + first + ": no value above "), std::string::npos) << doubted.err;
  EXPECT_NE(doubted.err.find(advice), std::string::npos) << doubted.err;
  EXPECT_EQ(doubted.err.find(advice), doubted.err.rfind(advice));
  EXPECT_EQ(run_adit({"run", first, "--set", "grey16_depth_bits=12"}).err, "");
  EXPECT_EQ(run_adit({"run", first, "--quiet"}).err, "");
  const Outcome cut_off = run_adit({"run", first, "--set", "grey16_depth_bits=10"});
  EXPECT_NE(cut_off.err.find("but grey16_depth_bits is 10: all above are cut off"), std::string::npos) << cut_off.err;
}

TEST(RunFaults, AFullDiskUnderStandardOutputIsTold) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png");
  for (const std::string& arguments :
       {std::string("--help"), std::string("--version"), std::string("run --help"), std::string("config"),
        std::string("run '") + image + "'", std::string("explain '") + image + "' -o -",
        std::string("bench --seconds 0.05 --size 32x32")}) {
    const int status = std::system(("'" ADIT_PROGRAM "' " + arguments + " >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 6) << arguments;
  }
}

}  // namespace
