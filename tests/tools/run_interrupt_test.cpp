#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using Names = std::vector<std::string>;

/// One picture, named so often that the work takes minutes.
std::vector<std::string> long_run(const std::string& image) {
  std::vector<std::string> arguments{"run"};
  arguments.resize(20001, image);
  return arguments;
}

void expect_clean_end(int signal) {
  const ScratchFolder folder;
  const ScratchFolder outputs;
  auto arguments = long_run(make_passage(folder / "a.png", 200, 110, 640, 480));
  for (const std::string& word : {std::string("--csv"), (outputs / "t.csv").string(), std::string("--jsonl"),
                                  (outputs / "t.jsonl").string(), std::string("--frames"), (outputs / "f").string()}) {
    arguments.push_back(word);
  }
  const Outcome outcome =
      run_adit(arguments, {.signal = signal, .delay_ms = 100, .signal_when = outputs / "f/000003_a.png"});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const auto said = lines_of(outcome.err);
  ASSERT_FALSE(said.empty());
  const std::string csv = read_text(outputs / "t.csv");
  const auto rows = rows_of(csv);
  ASSERT_GT(rows.size(), 4u);
  ASSERT_LT(rows.size(), 20001u);
  EXPECT_EQ(said.back(), "adit: interrupted after " + std::to_string(rows.size() - 1) +
                             " of 20000 frames; what was written is whole");
  EXPECT_EQ(csv.back(), '\n');
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto json = lines_of(read_text(outputs / "t.jsonl"));
  EXPECT_EQ(json.size(), rows.size() - 1);
  EXPECT_TRUE(nlohmann::json::accept(json.back()));
  EXPECT_EQ(outputs.names(), (Names{"f", "t.csv", "t.jsonl"}));
}

TEST(RunInterrupt, CtrlCEndsCleanly) { expect_clean_end(SIGINT); }
TEST(RunInterrupt, KillEndsCleanly) { expect_clean_end(SIGTERM); }

TEST(RunInterrupt, BenchSaysSo) {
  const Outcome outcome = run_adit({"bench", "--seconds", "600"}, {.signal = SIGINT, .delay_ms = 3000});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("adit: interrupted after ")) << outcome.err;
}

}  // namespace
