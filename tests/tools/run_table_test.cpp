#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using Cells = std::vector<std::string>;
constexpr const char* kColumns =
    "source,frame,stamp_s,status,confidence,u_px,v_px,sx,sy,azimuth_deg,elevation_deg,area_fraction,yaw_rate_rad_s,";
enum Column { kSource, kFrame, kStamp, kStatus, kConfidence, kU, kV, kSx, kSy, kAzimuth, kElevation, kArea, kYawRate };

TEST(RunTable, OneRowAFrameInInputOrder) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 12);
  const Outcome outcome = run_adit({"run", passages, "--quiet", "--fps", "10"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with(kColumns));
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 13u);
  for (int i = 0; i < 12; ++i) {
    const Cells& row = rows[static_cast<std::size_t>(i) + 1];
    EXPECT_EQ(row[kSource], passages + "/frame" + std::to_string(i) + ".png");
    EXPECT_EQ(row[kFrame], std::to_string(i));
    EXPECT_DOUBLE_EQ(std::stod(row[kStamp]), i / 10.0);
    EXPECT_EQ(row[kStatus], "found");
    EXPECT_NEAR(std::stod(row[kU]), 100 + 8 * i, 3.0);
    EXPECT_NEAR(std::stod(row[kV]), 110, 6.0);
  }
}

TEST(RunTable, DiscToTheRightTurnsRightAndNothingIsRemembered) {
  const ScratchFolder folder;
  const std::string right = make_passage(folder / "right.png", 260);
  const std::string left = make_passage(folder / "left.png", 60);
  const auto rows = rows_of(run_adit({"run", right, left, right, "--quiet"}).out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_GT(std::stod(rows[1][kSx]), 0.1);
  EXPECT_GT(std::stod(rows[1][kAzimuth]), 5.0);
  EXPECT_LT(std::stod(rows[1][kYawRate]), -0.1);
  EXPECT_GT(std::stod(rows[2][kYawRate]), 0.1);
  EXPECT_EQ(rows[3][kYawRate], rows[1][kYawRate]) << "single pictures have no history";
}

TEST(RunTable, SequencesAreSteeredByTheController) {
  const ScratchFolder folder;
  const std::string right = make_passage(folder / "right.png", 290);
  const auto rows =
      rows_of(run_adit({"run", right, right, right, "--method", "paper", "--sequence", "--fps", "30", "--quiet"}).out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(std::stod(rows[1][kYawRate]), 0.0) << "steering starts from zero";
  EXPECT_NEAR(std::stod(rows[2][kYawRate]), -2.0 / 30.0, 1e-5) << "and grows by its acceleration";
  EXPECT_NEAR(std::stod(rows[3][kYawRate]), -4.0 / 30.0, 1e-5);
}

TEST(RunTable, ACameraThatHangsIsNamedInASequence) {
  const ScratchFolder folder;
  const std::string same = make_passage(folder / "same.png", 290);
  std::vector<std::string> arguments{"run", "--sequence", "--quiet"};
  for (int i = 0; i < 8; ++i) arguments.push_back(same);
  const auto rows = rows_of(run_adit(arguments).out);
  ASSERT_EQ(rows.size(), 9u);
  EXPECT_EQ(rows[1][kStatus], "found");
  EXPECT_EQ(rows[8][kStatus], "frozen_frame");
}

TEST(RunTable, NumbersThatDoNotExistAreEmpty) {
  const ScratchFolder folder;
  const std::string black = make_passage(folder / "black.png", 160, 120, 64, 48);
  const Outcome outcome = run_adit({"run", black, "--quiet", "--set", "too_dark_light_max=255"});
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(rows[1][kStatus], "too_dark");
  for (const Column column : {kU, kV, kSx, kSy, kAzimuth, kElevation, kArea, kYawRate}) {
    EXPECT_EQ(rows[1][static_cast<std::size_t>(column)], "") << column;
  }
}

TEST(RunTable, JobsChangeNoByte) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 25);
  truncate_copy(passages + "/frame3.png", passages + "/frame3b.png", 0.5);
  const std::string clip = make_clip(folder / "c.avi", 30);
  const auto run = [&](const std::string& jobs) {
    const Outcome outcome = run_adit({"run", passages, clip, "--sequence", "--csv", "-", "--jsonl",
                                      (folder / jobs).string(), "--jobs", jobs, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 5);
    return outcome.out + read_text(folder / jobs);
  };
  const std::string one = run("1");
  EXPECT_EQ(lines_of(one).size(), 1u + 2u * 56u);
  EXPECT_EQ(run("2"), one);
  EXPECT_EQ(run("7"), one);
}

TEST(RunTable, CsvAndJsonTellTheSame) {
  const ScratchFolder folder;
  const std::string clip = make_clip(folder / "c.avi", 10);
  const std::string json_file = (folder / "t.jsonl").string();
  const Outcome outcome = run_adit({"run", clip, "--csv", "-", "--jsonl", json_file, "--quiet"});
  const auto rows = rows_of(outcome.out);
  const auto lines = lines_of(read_text(json_file));
  ASSERT_EQ(rows.size(), 11u);
  ASSERT_EQ(lines.size(), 10u);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto json = nlohmann::json::parse(lines[i]);
    for (std::size_t column = 0; column < rows[0].size(); ++column) {
      const auto& value = json.at(rows[0][column]);
      const std::string& cell = rows[i + 1][column];
      if (value.is_null()) {
        EXPECT_EQ(cell, "");
      } else if (value.is_number()) {
        EXPECT_DOUBLE_EQ(std::stod(cell), value.get<double>());
      } else {
        EXPECT_EQ(cell, value.get<std::string>());
      }
    }
    EXPECT_NEAR(json["stamp_s"].get<double>(), static_cast<double>(i) / 20.0, 0.002);
  }
}

TEST(RunTable, LimitEndsEarlyAndTimingIsAColumn) {
  const ScratchFolder folder;
  const std::string passages = make_passages(folder / "p", 6);
  const auto rows = rows_of(run_adit({"run", passages, "--limit", "4", "--timing", "--quiet"}).out);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].back(), "find_ms");
  EXPECT_GT(std::stod(rows[4].back()), 0.0);
}

TEST(RunTable, PatternIsExpandedAndSettingBeforeInputLeavesTheInputAlone) {
  const ScratchFolder folder;
  make_passages(folder / "p", 11);
  const Outcome outcome =
      run_adit({"run", "--set", "cluster_count=5", "p/frame*.png", "--quiet"}, {.folder = folder.path()});
  const auto rows = rows_of(outcome.out);
  ASSERT_EQ(rows.size(), 12u) << outcome.err;
  EXPECT_EQ(rows[3][kSource], "p/frame2.png");
  EXPECT_EQ(rows[11][kSource], "p/frame10.png");
}

TEST(RunTable, CameraGivesTheDirections) {
  const ScratchFolder folder;
  const std::string image = make_passage(folder / "a.png", 220, 110);
  const std::string camera =
      write_text(
          folder / "cam.yaml",
          "image_width: 320\nimage_height: 240\ncamera_name: t\ncamera_matrix: {rows: 3, cols: 3, data: [200, 0, "
          "160, 0, 200, 120, 0, 0, 1]}\ndistortion_model: plumb_bob\ndistortion_coefficients: {rows: 1, cols: "
          "5, data: [0, 0, 0, 0, 0]}\n")
          .string();
  const auto rows = rows_of(run_adit({"run", image, "--camera", camera, "--quiet"}).out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(std::stod(rows[1][kSx]), (std::stod(rows[1][kU]) - 160.0) / 200.0, 1e-5);
  EXPECT_NEAR(std::stod(rows[1][kSy]), (std::stod(rows[1][kV]) - 120.0) / 200.0, 1e-5);
}

}  // namespace
