#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;

/// A short flight through coarse rock on small frames: what is tested here is the program, not the picture.
std::vector<std::string> short_flight(const std::string& time_s, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {
      "fly",   "s_bend",        "--time", time_s,           "--set",  "course.cell_m=0.3",
      "--set", "lens.width=96", "--set",  "lens.height=72", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Fly, WritesATableASummaryAMapAndFigures) {
  const ScratchFolder folder;
  const Outcome outcome = run_adit(short_flight("1", {"--out", "flight", "--video", "--still", "0.5", "--sensors"}),
                                   {.folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(read_text(folder / "flight/flight.csv"));
  ASSERT_EQ(rows.size(), 31u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto json = nlohmann::json::parse(read_text(folder / "flight/summary.json"));
  for (const char* key : {"outcome", "distance_m", "duration_s", "side_clearance_min_m", "clearance_min_m",
                          "heading_error_passage_deg", "heading_error_deepest_deg", "sx_jitter", "found_fraction",
                          "bends", "false_stops", "missed_stops", "real_time_factor"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["outcome"], "timeout");
  EXPECT_EQ(json["frames"], 30);
  for (const char* name : {"map.png", "map.yaml", "flight.mp4", "still_000.50.png", "imu.csv", "scans.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / ("flight/" + std::string(name)))) << name;
  const auto shots = nlohmann::json::parse(read_text(folder / "flight/shots/shots.json"));
  EXPECT_EQ(shots["frames"].size(), 30u);
  EXPECT_EQ(shots["stages"], shots["frames"]) << "each frame with its stages";
  const Outcome report = run_adit({"report", "flight"}, {.folder = folder.path()});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string page = read_text(folder / "flight/report.html");
  EXPECT_NE(page.find(R"("overlay_is_drawn":false)"), std::string::npos) << "of the shots, not of the film";
  for (const auto& tile : shots["tiles"]) EXPECT_NE(page.find(tile.dump()), std::string::npos) << tile;
  EXPECT_GE(shots["tiles"].size(), 5u);
}

TEST(Fly, DustOnTheWayIsInTheTableAndAnEventOfTheReport) {
  const ScratchFolder folder;
  const Outcome outcome =
      run_adit(short_flight("1", {"--dust", "0.2", "--out", "flight", "--report", "page.html", "--set",
                                  "lens.width=160", "--set", "lens.height=120", "--set", "flight.drop_fraction=0"}),
               {.folder = folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = rows_of(read_text(folder / "flight/flight.csv"));
  const auto flags_at = std::find(rows[0].begin(), rows[0].end(), "flags") - rows[0].begin();
  ASSERT_LT(flags_at, static_cast<std::ptrdiff_t>(rows[0].size()));
  EXPECT_EQ(rows.back()[static_cast<std::size_t>(flags_at)], "dust");
  EXPECT_NE(read_text(folder / "page.html").find(R"("dust","flag dust")"), std::string::npos);
}

TEST(Fly, TheSameSeedGivesTheSameBytesOnOneThreadAndTwo) {
  const ScratchFolder folder;
  for (const std::string threads : {"1", "2"})
    ASSERT_EQ(run_adit(short_flight("1", {"--out", "on_" + threads, "--set", "render.threads=" + threads}),
                       {.folder = folder.path()})
                  .exit_code,
              0);
  ASSERT_EQ(run_adit(short_flight("1", {"--out", "other", "--seed", "2"}), {.folder = folder.path()}).exit_code, 0);
  const std::string one = read_text(folder / "on_1/flight.csv");
  EXPECT_GT(one.size(), 2000u);
  EXPECT_EQ(one, read_text(folder / "on_2/flight.csv"));
  EXPECT_EQ(read_text(folder / "on_1/map.png"), read_text(folder / "on_2/map.png"));
  EXPECT_NE(one, read_text(folder / "other/flight.csv"));
}

TEST(Fly, ManySeedsGiveATableAndARate) {
  const ScratchFolder folder;
  auto arguments = short_flight("0.5", {"--seeds", "3..5", "--jobs", "2", "--out", "runs"});
  ASSERT_EQ(run_adit(arguments, {.folder = folder.path()}).exit_code, 0);
  const auto rows = rows_of(read_text(folder / "runs/runs.csv"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1][0], "3");
  EXPECT_EQ(rows[3][0], "5");
  const auto json = nlohmann::json::parse(read_text(folder / "runs/runs.json"));
  EXPECT_EQ(json["runs"], 3);
  EXPECT_EQ(json["successes"], 0) << "half a second reaches no goal";
  EXPECT_EQ(json["outcomes"]["timeout"], 3);
  // A flight among others is the flight alone.
  ASSERT_EQ(run_adit(short_flight("0.5", {"--seed", "4", "--out", "alone"}), {.folder = folder.path()}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "alone/flight.csv"), read_text(folder / "runs/seed_4/flight.csv"));
}

TEST(Fly, AnInterruptedFlightIsWhole) {
  const ScratchFolder folder;
  const Outcome outcome =
      run_adit(short_flight("600", {"--out", "flight", "--speed", "0.2", "--set", "stuck_radius_m=0.1"}),
               {.folder = folder.path(), .signal = 2, .delay_ms = 3000});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const auto json = nlohmann::json::parse(read_text(folder / "flight/summary.json"));
  EXPECT_EQ(json["outcome"], "interrupted");
  for (const auto& entry : std::filesystem::directory_iterator(folder / "flight"))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
}

TEST(Fly, ManyThatAreInterruptedBeforeTheFirstIsDoneSaySo) {
  const Outcome outcome =
      run_adit(short_flight("600", {"--runs", "2", "--speed", "0.2", "--set", "stuck_radius_m=0.1"}),
               {.signal = 2, .delay_ms = 3000});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("adit: interrupted after 0 of 2 flights")) << outcome.err;
}

TEST(Fly, FaultsAreOneLineAndNameWhatIsWrong) {
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  } faults[] = {
      {{"fly"}, 2, "COURSE"},
      {{"fly", "nowhere"}, 4, "there is no course 'nowhere'; there are: "},
      {{"fly", "s_bend", "--set", "speed_ms=1"}, 3, "did you mean 'speed_m_s'"},
      {{"fly", "s_bend", "--set", "forward_m=0"}, 3, "name the section"},
      {{"fly", "s_bend", "--set", "speed_m_s=-1"}, 3, "out of range"},
      {{"fly", "s_bend", "--lamp", "candle"}, 2, "flood_460lux"},
      {{"fly", "s_bend", "--prefer", "up"}, 2, "--prefer: up not in"},
      {{"fly", "s_bend", "--prefer", "left", "--method", "paper"}, 2, "pilot=navigator"},
      {{"fly", "s_bend", "--dust", "nan"}, 2, "--dust: 'nan'"},
      {{"fly", "s_bend", "--speed", "nan"}, 2, "--speed: 'nan'"},
      {{"fly", "s_bend", "--time", "inf"}, 2, "--time: 'inf'"},
      {{"fly", "s_bend", "--start", "nan,0,0,0"}, 2, "--start: 'nan'"},
      {{"fly", "s_bend", "--start", "500,0,0,0", "--set", "course.cell_m=0.3"}, 3, "no rock beneath or around"},
      {{"fly", "s_bend", "--video"}, 2, "--out"},
      {{"fly", "--set", "speed_m_s=1", "nowhere"}, 4, "nowhere"},
      {{"fly", "s_bend", "--seeds", "9..3"}, 2, "A..B"},
      {{"fly", "s_bend", "--start", "2,0,0,0", "--set", "course.cell_m=0.3", "--set", "body_radius_m=2"},
       3,
       "body_radius_m"},
      {{"fly", "--world", "nothing.world"}, 4, "nothing.world"},
  };
  const ScratchFolder folder;
  for (const auto& fault : faults) {
    const Outcome outcome = run_adit(fault.arguments, {.folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << outcome.err;
  }
}

}  // namespace
