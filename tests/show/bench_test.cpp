#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "bench_timing.hpp"

namespace adit::tools {
namespace {

struct Outcome {
  std::string text;
  int status = -1;
};

Outcome run(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((std::string("\"" ADIT_PROGRAM "\" ") + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> part{};
  while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe)) outcome.text.append(part.data(), read);
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

TEST(Bench, PercentilesAreNearestRank) {
  Samples samples;
  EXPECT_EQ(samples.median_ms(), 0.0);
  for (int i = 1000; i >= 1; --i) samples.add(i);
  EXPECT_EQ(samples.median_ms(), 500.0);
  EXPECT_EQ(samples.percentile_ms(0.999), 999.0);
  EXPECT_EQ(samples.percentile_ms(1.0), 1000.0);
  EXPECT_EQ(samples.percentile_ms(0.0001), 1.0);
}

TEST(Bench, JsonHasItsKeys) {
  const Outcome outcome = run("bench --seconds 0.05 --size 96x64 --json -");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  for (const char* key : {"frame_ms_median", "frame_ms_p999", "copy_ms_median", "opencv_chain_ms_median",
                          "opencv_strong_ms_median", "noise_ms_median", "frame_4k_ms_median"}) {
    ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_GT(json[key].get<double>(), 0.0) << key;
  }
  EXPECT_GE(json["frame_ms_p999"].get<double>(), json["frame_ms_median"].get<double>());
  EXPECT_EQ(json["width"], 96);
  EXPECT_TRUE(json["target_ms_median"].contains(json["target"].get<std::string>()));
  for (const char* stage : {"dark_channel", "scattering_depth", "closing", "clusters", "moments"}) {
    EXPECT_TRUE(json["stage_ms"].contains(stage)) << stage;
  }
}

TEST(Bench, ItsExampleRuns) {
  const std::string help = run("bench --help").text;
  ASSERT_NE(help.find("Example: adit bench --seconds 10 --json bench.json"), std::string::npos) << help;
  // The same with less time.
  const std::string file = testing::TempDir() + "adit-bench-example.json";
  const Outcome outcome = run("bench --seconds 0.05 --json \"" + file + "\"");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("frame, whole"), std::string::npos) << outcome.text;
  EXPECT_EQ(std::remove(file.c_str()), 0) << "no file of figures";
}

TEST(Bench, ATargetCanBeForced) {
  const Outcome outcome = run("bench --seconds 0.05 --size 64x64 --target plain --json -");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(nlohmann::json::parse(outcome.text)["target"], "plain");
}

TEST(Bench, WrongOptionsAreRefusedInOneLine) {
  EXPECT_EQ(run("bench --target mmx").status, 2);
  EXPECT_EQ(run("bench --size 8x8").status, 2);
  EXPECT_EQ(run("bench --size 640x").status, 2);
  EXPECT_EQ(run("bench --input /nowhere.png").status, 4);
  const Outcome outcome = run("bench --target mmx");
  EXPECT_NE(outcome.text.find("--target: mmx not in {"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("plain}"), std::string::npos) << outcome.text;
}

TEST(Explain, WritesAPanelOrSaysWhyNot) {
  const std::string panel = testing::TempDir() + "adit-panel.png";
  const Outcome good = run("explain \"" ADIT_SOURCE_DIR "/data/tunnel.jpg\" -o \"" + panel + "\"");
  EXPECT_EQ(good.status, 0) << good.text;
  EXPECT_NE(good.text.find("found"), std::string::npos);
  std::remove(panel.c_str());
  EXPECT_EQ(run("explain /nowhere.png").status, 4);
  EXPECT_EQ(run("explain \"" ADIT_SOURCE_DIR "/data/tunnel.jpg\" -o /nowhere/panel.png").status, 6);
  EXPECT_EQ(run("explain \"" ADIT_SOURCE_DIR "/data/tunnel.jpg\" -o panel.gif").status, 2);
  EXPECT_EQ(run("explain \"" ADIT_SOURCE_DIR "/data/tunnel.jpg\" --set omega=9").status, 3);
}

}  // namespace
}  // namespace adit::tools
