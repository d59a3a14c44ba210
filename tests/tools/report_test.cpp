// `adit report`, and --report of run, eval and fly.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using nlohmann::json;

/// What the page shows, as it stands in it.
json shown_in(const std::filesystem::path& page) {
  const std::string text = read_text(page);
  const std::string begin = "id=\"report\">";
  const std::size_t from = text.find(begin) + begin.size();
  return json::parse(text.substr(from, text.find("</script>", from) - from));
}

std::vector<std::string> texts_of(const json& events) {
  std::vector<std::string> texts;
  for (const json& event : events) texts.push_back(event[2].get<std::string>() + ": " + event[3].get<std::string>());
  return texts;
}

TEST(Report, OfARunFolderIsThatOfTheRun) {
  const ScratchFolder folder;
  const std::string clip = make_clip(folder / "drift.avi", 8);
  const std::string at_once = (folder / "at_once.html").string(), run = (folder / "run").string();
  const Outcome outcome = run_adit({"run", clip, "--out", run, "--report", at_once, "--method", "paper", "--set",
                                    "cluster_count=7", "--jobs", "3", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const Outcome report = run_adit({"report", run});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(report.out, run + "/report.html\n");
  const json a = shown_in(at_once), b = shown_in(folder / "run/report.html");
  EXPECT_EQ(a["rows"], 8);
  EXPECT_EQ(a["frames"]["rows"].size(), 8u);
  EXPECT_EQ(a["stages"]["rows"].size(), 8u);
  EXPECT_EQ(a["origin"]["changed"], json({"finder.method: paper", "finder.cluster_count: 7"}));
  for (const char* part : {"rows", "time_s", "columns", "words", "sources", "frames", "stages", "events", "figures"})
    EXPECT_EQ(a[part], b[part]) << part;
  EXPECT_EQ(a["origin"], b["origin"]);
}

TEST(Report, NeedsNoNetwork) {
  const ScratchFolder folder;
  const auto page = (folder / "p.html").string();
  ASSERT_EQ(run_adit({"run", make_passage(folder / "a<b.png"), "--report", page, "--quiet"}).exit_code, 0);
  const std::string text = read_text(page);
  for (const char* loads : {"src=\"http", "href=\"http", "@import", "url(", "fetch(", "<b.png"})
    EXPECT_EQ(text.find(loads), std::string::npos) << loads;
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
}

/// Rows of a flight: found, then refused for a second, a lost frame, a jump.
std::string flight_table() {
  std::string text = "frame,stamp_s,x_m,y_m,yaw_deg,delivery,status,confidence,sx,azimuth_deg,command,yaw_rate_rad_s\n";
  for (int i = 0; i < 60; ++i) {
    const bool refused = i >= 20 && i < 40, lost = i == 50;
    text += std::to_string(i) + "," + std::to_string(0.05 * i) + "," + std::to_string(0.1 * i) + ",0,0," +
            (lost ? "dropped," : "fresh,") +
            (lost      ? ","
             : refused ? "no_opening,0"
                       : "found,0.5") +
            "," +
            (refused || lost ? ","
             : i < 55        ? "0.1,5"
                             : "0.5,30") +
            (refused ? ",hold,0\n" : ",steer,0.1\n");
  }
  return text;
}

TEST(Report, TellsWhatHappened) {
  const ScratchFolder folder;
  write_text(folder / "flight.csv", flight_table());
  write_text(folder / "summary.json", R"({"outcome": "goal", "distance_m": 6.0, "to_goal_m": null})");
  const Outcome report = run_adit({"report", folder.path().string(), "-o", (folder / "page.html").string()});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  EXPECT_NE(report.err.find("no film"), std::string::npos) << report.err;
  const json page = shown_in(folder / "page.html");
  EXPECT_EQ(texts_of(page["events"]),
            (std::vector<std::string>{"hold: the command was to hold", "refused: no_opening",
                                      "dropped: the camera's frame was dropped",
                                      "jump: the best opening moved from +5.0 to +30.0 deg"}));
  EXPECT_EQ(page["events"][0][0], 20);
  EXPECT_EQ(page["events"][0][1], 39);
  EXPECT_EQ(page["figures"][0], json({"outcome", "goal"}));
  EXPECT_EQ(page["figures"][1], json({"distance", "6 m"}));
  EXPECT_TRUE(page["frames"]["rows"].empty());
}

/// A table of `run` over one video, then another: the tracker goes from one opening to another at 12 (and back, to one
/// that is seen twice, at 20), while the answer jumps about; the second video's first track is its own.
std::string followed_table() {
  std::string text = "source,frame,stamp_s,status,confidence,azimuth_deg,flags,track,track_azimuth_deg\n";
  for (int i = 0; i < 40; ++i) {
    const bool second = i >= 30, right = i >= 12;
    text += std::string(second ? "b.avi," : "a.avi,") + std::to_string(second ? i - 30 : i) + "," +
            std::to_string(0.05 * (second ? i - 30 : i)) + ",found,0.5," + (i % 2 == 0 ? "-12" : "20") + "," +
            (i >= 3 && i < 6 ? "glare" : "") + "," +
            (second    ? "1,-40"
             : i >= 20 ? "3,21"
             : right   ? "2,20.5"
                       : "1,-12") +
            "\n";
  }
  return text;
}

TEST(Report, AChangeOfBranchIsTheTrackers) {
  const ScratchFolder folder;
  write_text(folder / "headings.csv", followed_table());
  const Outcome report = run_adit({"report", folder.path().string(), "-o", (folder / "page.html").string()});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const json page = shown_in(folder / "page.html");
  EXPECT_EQ(
      texts_of(page["events"]),
      (std::vector<std::string>{"glare: flag glare",
                                "branch: another opening is followed: at +20.5 deg, the one before was at -12.0 deg"}));
  EXPECT_EQ(page["events"][0][0], 3);
  EXPECT_EQ(page["events"][0][1], 5);
  EXPECT_EQ(page["events"][1][0], 12);
}

TEST(Report, AChangeOfBranchIsToldOfARunOverImages) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "drift");
  // The passage is on the left for a second and a half, then on the right: more than the tracker waits.
  for (int i = 0; i < 30; ++i)
    make_passage(folder / "drift" / ("frame" + std::to_string(100 + i) + ".png"), i < 15 ? 70 : 250);
  const std::string page = (folder / "page.html").string();
  const Outcome run = run_adit({"run", (folder / "drift").string(), "--sequence", "--fps", "10", "--method", "adit",
                                "--report", page, "--csv", (folder / "t.csv").string(), "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json events = shown_in(page)["events"];
  int branches = 0;
  for (const json& event : events)
    if (event[2] == "branch") {
      ++branches;
      EXPECT_GE(event[0], 16) << "not with the frame, but when the tracker changes its mind";
      EXPECT_LE(event[0], 28);
    }
  EXPECT_EQ(branches, 1) << events.dump(1);
  EXPECT_EQ(events.dump().find("jump"), std::string::npos) << events.dump(1);
}

TEST(Report, OfEvalIsTheGalleryInOneFile) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "set");
  make_passage(folder / "set/a.png");
  write_text(folder / "set/openings.json", R"({"openings": {"a.png": [[160, 70, 240, 150]]}})");
  const std::string page = (folder / "e.html").string();
  const Outcome outcome = run_adit({"eval", (folder / "set").string(), "--report", page, "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(read_text(page).find("data:image/jpeg;base64,"), std::string::npos);
}

TEST(Report, FaultsAreOneLine) {
  const ScratchFolder folder;
  const auto made = [&folder](const char* name, const char* table) {
    std::filesystem::create_directory(folder / name);
    if (table != nullptr) write_text(folder / name / "headings.csv", table);
    return (folder / name).string();
  };
  const std::string two = made("two", nullptr);
  write_text(folder / "two/a.csv", "x");
  write_text(folder / "two/b.csv", "x");
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  } faults[] = {
      {{"report"}, 2, "folder"},
      {{"report", (folder / "none").string()}, 4, "no such folder"},
      {{"report", made("empty", nullptr)}, 4, "there is no table"},
      {{"report", two}, 4, "which of its tables"},
      {{"report", made("alien", "a,b\n1,2\n")}, 4, "no table of 'adit run'"},
      {{"report", made("header", "source,stamp_s,status\n")}, 4, "no rows"},
      {{"report", made("short", "source,stamp_s,status\na,0\n")}, 4, "headings.csv:2: a row of 2 cells"},
      {{"report", made("good", "source,stamp_s,status\na,0,found\n"), "-o", "/nowhere/r.html", "--quiet"},
       6,
       "/nowhere"},
      {{"eval", "x", "--report", "page"}, 2, ".html"},
  };
  for (const auto& fault : faults) {
    const Outcome outcome = run_adit(fault.arguments);
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << outcome.err;
  }
}

}  // namespace
