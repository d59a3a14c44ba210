#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;

/// Small frames of coarse rock: what is tested here is the program, not the picture.
std::vector<std::string> few_frames(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {
      "render", "s_bend", "--frames", "3", "--size", "96x72", "--set", "course.cell_m=0.3", "--quiet", "--out", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Which column of the table has this name in its head.
std::size_t column_of(const std::vector<std::string>& head, const char* name) {
  return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
}

void expect_same_set(const std::filesystem::path& a, const std::filesystem::path& b) {
  EXPECT_EQ(read_text(a / "truth.csv"), read_text(b / "truth.csv"));
  for (const char* name : {"frames/000000.png", "frames/000002.png", "range/000001.png"}) {
    const std::string bytes = read_text(a / name);
    EXPECT_GT(bytes.size(), 100u) << name;
    EXPECT_TRUE(bytes == read_text(b / name)) << name;
  }
}

TEST(Render, WritesFramesRangesAndTruth) {
  const ScratchFolder folder;
  const Outcome outcome = run_adit(few_frames("set", {"--dust", "0.05"}), {.folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(read_text(folder / "set/truth.csv"));
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto column = [&](const char* name) { return column_of(rows[0], name); };
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const cv::Mat frame = cv::imread((folder / ("set/" + rows[i][column("image")])).string(), cv::IMREAD_UNCHANGED);
    cv::Mat range = cv::imread((folder / ("set/" + rows[i][column("range_image")])).string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(frame.type(), CV_8UC3);
    ASSERT_EQ(range.type(), CV_16UC1);
    ASSERT_EQ(frame.size(), cv::Size(96, 72));
    ASSERT_EQ(range.size(), cv::Size(96, 72));
    range.setTo(65535, range == 0);  // both mouths are open
    // Nothing is nearer than the rock that is nearest in any direction, but for the lens, 0.1 m before the body.
    double least_mm = 0.0, most_mm = 0.0;
    cv::minMaxLoc(range, &least_mm, &most_mm);
    EXPECT_GT(0.001 * least_mm + 0.101, std::stod(rows[i][column("clearance_m")]));
    // The deepest direction is a mean over 4 deg.
    EXPECT_GT(0.001 * most_mm + 0.5, std::stod(rows[i][column("deepest_range_m")]));
    EXPECT_LT(std::abs(std::stod(rows[i][column("passage_azimuth_deg")])), 90.0);
    EXPECT_EQ(rows[i][column("dust_1_m")], "0.05000000075") << "as the renderer has it";
  }
  const auto json = nlohmann::json::parse(read_text(folder / "set/dataset.json"));
  EXPECT_EQ(json["frames"], 3);
  EXPECT_EQ(json["complete"], true);
  const Outcome run = run_adit({"run", "set/frames", "--camera", "set/camera.yaml", "--csv", "t.csv", "--quiet"},
                               {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Render, LampsThatFlashMakePairsFromOnePlace) {
  const ScratchFolder folder;
  const Outcome outcome = run_adit(few_frames("set", {"--set", "lamps.flash=1"}), {.folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(read_text(folder / "set/truth.csv"));
  ASSERT_EQ(rows.size(), 4u);
  const auto cell = [&](std::size_t row, const char* name) { return rows[row][column_of(rows[0], name)]; };
  EXPECT_EQ(cell(1, "x_m"), cell(2, "x_m"));
  EXPECT_NE(cell(1, "x_m"), cell(3, "x_m"));
  const auto mean_of = [&](const char* name) { return cv::mean(cv::imread((folder / name).string()))[1]; };
  EXPECT_GT(mean_of("set/frames/000000.png"), 2.0 * mean_of("set/frames/000001.png")) << "what is left is noise";
  const Outcome run = run_adit(
      {"run", "set/frames", "--camera", "set/camera.yaml", "--flash", "--method", "adit", "--csv", "t.csv", "--quiet"},
      {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Render, SeedAndSettingsFileMakeTheSameBytesOnAnyNumberOfThreads) {
  const ScratchFolder folder;
  ASSERT_EQ(run_adit(few_frames("one", {"--jobs", "1", "--rig", "narrow_beam", "--set", "lens.hfov_deg=90", "--set",
                                        "view_yaw_max_deg=5"}),
                     {.folder = folder.path()})
                .exit_code,
            0);
  // The settings file alone says all but rig and seed, size included.
  const Outcome again = run_adit({"render", "s_bend", "--frames", "3", "--rig", "narrow_beam", "--jobs", "2",
                                  "--config", "one/settings.yaml", "--quiet", "--out", "again"},
                                 {.folder = folder.path()});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  expect_same_set(folder / "one", folder / "again");
  ASSERT_EQ(run_adit(few_frames("other", {"--seed", "2"}), {.folder = folder.path()}).exit_code, 0);
  EXPECT_NE(read_text(folder / "one/truth.csv"), read_text(folder / "other/truth.csv"));
}

TEST(Render, TakesPosesFromATable) {
  const ScratchFolder folder;
  std::ofstream(folder / "poses.csv") << "stamp_s,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg\n"
                                         "0,3,0.2,1,0,0,10\n0.5,3.5,0.2,1,0,2,0\n1,4,0.2,1,0,0,-10\n";
  ASSERT_EQ(run_adit(few_frames("set", {"--poses", "poses.csv"}), {.folder = folder.path()}).exit_code, 0);
  const auto rows = rows_of(read_text(folder / "set/truth.csv"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[2][4], "3.5000");
  EXPECT_EQ(rows[2][9], "0.000");
  EXPECT_EQ(rows[2][13], "-0.34907") << "20 deg to the right in 1 s";
}

TEST(Render, AnInterruptedSetIsWhole) {
  const ScratchFolder folder;
  auto arguments = few_frames("set");
  arguments[3] = "100000";
  const Outcome outcome =
      run_adit(arguments, {.folder = folder.path(), .signal = 2, .signal_when = folder / "set/frames/000002.png"});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const auto rows = rows_of(read_text(folder / "set/truth.csv"));
  ASSERT_GE(rows.size(), 2u);
  EXPECT_EQ(nlohmann::json::parse(read_text(folder / "set/dataset.json"))["complete"], false);
  std::size_t frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "set/frames")) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    ++frames;
  }
  EXPECT_EQ(frames, rows.size() - 1);
}

TEST(Render, FaultsAreOneLineAndNameWhatIsWrong) {
  const ScratchFolder folder;
  std::ofstream(folder / "short.csv") << "x_m,y_m\n1,2\n";
  std::ofstream(folder / "words.csv") << "x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg\n1,2,three,0,0,0\n";
  std::filesystem::create_directories(folder / "full/frames");
  std::ofstream(folder / "full/frames/old.png") << "x";
  const std::vector<std::string> coarse = {"--set", "course.cell_m=0.3", "--size", "96x72"};
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  } faults[] = {
      {{"--out", "a"}, 2, "COURSE"},
      {{"s_bend"}, 2, "--out"},
      {{"s_bend", "--out", "a", "--size", "640"}, 2, "WIDTHxHEIGHT"},
      {{"s_bend", "--out", "a", "--size", "8x8"}, 2, "sides of 16 to 4096 px"},
      {{"s_bend", "--out", "a", "--rig", "candle"}, 2, "flood_460lux"},
      {{"s_bend", "--out", "a", "--poses", "none.csv"}, 4, "none.csv"},
      {{"s_bend", "--out", "a", "--poses", "short.csv"}, 4, "z_m"},
      {{"s_bend", "--out", "a", "--poses", "words.csv"}, 4, "words.csv:2"},
      {{"s_bend", "--out", "a", "--set", "free_radius_m=4"}, 3, "free_radius_m"},
      {{"s_bend", "--out", "a", "--set", "above_floor_max_m=0.2"}, 3, "above_floor_min_m"},
      {{"s_bend", "--out", "full"}, 6, "another folder"},
  };
  for (const auto& fault : faults) {
    std::vector<std::string> arguments = {"render"};
    arguments.insert(arguments.end(), fault.arguments.begin(), fault.arguments.end());
    const bool has_size = std::find(fault.arguments.begin(), fault.arguments.end(), "--size") != fault.arguments.end();
    if (fault.arguments.size() > 2 && !has_size) arguments.insert(arguments.end(), coarse.begin(), coarse.end());
    arguments.push_back("--quiet");
    const Outcome outcome = run_adit(arguments, {.folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << fault.says << ": " << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << outcome.err;
  }
}

}  // namespace
