// --shard and `adit merge`: any number of parts gives the bytes of one machine, and nothing else is joined.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class ShardedRun : public testing::Test {
 protected:
  ShardedRun() {
    make_passages(folder_ / "drift", 7);
    make_clip(folder_ / "a.avi", 5);
    make_clip(folder_ / "b.avi", 3);
    write_text(folder_ / "drift/broken.png", "no picture");
  }

  Outcome adit(const Arguments& arguments) { return run_adit(arguments, {.folder = folder_.path()}); }
  Outcome run(const Arguments& more) {
    return adit(Arguments{"run", "drift", "a.avi", "b.avi", "drift/frame3.png", "--method", "adit", "--quiet"} + more);
  }
  void run_shards(int count, const Arguments& more = {}) {
    for (int i = count; i >= 1; --i) {  // in any order
      const std::string shard = std::to_string(i) + "/" + std::to_string(count);
      const Outcome outcome = run(Arguments{"--csv", "t.csv", "--jsonl", "t.jsonl", "--shard", shard} + more);
      EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 5) << shard << ": " << outcome.err;
    }
  }
  std::string part(int index, int count) const {
    return (folder_ / ("t.csv.part-" + std::to_string(index) + "-of-" + std::to_string(count))).string();
  }
  void expect_refused(const std::string& words, const Arguments& more = {}) {
    const Outcome outcome = adit(Arguments{"merge", "t.csv"} + more);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  }

  ScratchFolder folder_;
};

TEST_F(ShardedRun, AnyNumberOfPartsGivesTheBytesOfOneMachine) {
  run({"--csv", "whole.csv", "--jsonl", "whole.jsonl"});
  const std::string csv = read_text(folder_ / "whole.csv");
  ASSERT_EQ(lines_of(csv).size(), 1u + 8 + 5 + 3 + 1);
  for (const int count : {1, 3, 20}) {  // 11 items: eight pictures, two recordings, a picture
    run_shards(count);
    ASSERT_EQ(adit({"merge", "t.csv", "--remove"}).exit_code, 0);
    ASSERT_EQ(adit({"merge", "t.jsonl", "--remove", "--quiet"}).exit_code, 0);
    EXPECT_EQ(read_text(folder_ / "t.csv"), csv) << count;
    EXPECT_EQ(read_text(folder_ / "t.jsonl"), read_text(folder_ / "whole.jsonl")) << count;
    EXPECT_FALSE(fs::exists(part(1, count)));
  }
}

TEST_F(ShardedRun, PartsElsewhereAreNamed) {
  run({"--csv", "whole.csv"});
  run_shards(2);
  fs::create_directory(folder_ / "node");
  fs::rename(part(1, 2), folder_ / "node/first");
  EXPECT_EQ(adit({"merge", "t.csv", part(2, 2), "node/first"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "t.csv"), read_text(folder_ / "whole.csv"));
}

TEST_F(ShardedRun, MissingPartsAreNamedAndRunAgain) {
  run_shards(4);
  fs::remove(part(2, 4));
  fs::remove(part(4, 4));
  expect_refused("of 4 parts, 2 are missing: 2 and 4; run --shard 2/4");
  EXPECT_EQ(adit({"merge", "t.csv", "--missing"}).out, "2,4\n");
  run({"--csv", "t.csv", "--shard", "2/4"});
  run({"--csv", "t.csv", "--shard", "4/4"});
  EXPECT_EQ(adit({"merge", "t.csv", "--missing"}).out, "\n");
  EXPECT_EQ(adit({"merge", "t.csv"}).exit_code, 0);
}

TEST_F(ShardedRun, ForeignDuplicateAndDamagedPartsAreRefused) {
  expect_refused("no parts of it are there");
  run_shards(3);
  fs::copy_file(part(1, 3), folder_ / "copy");
  expect_refused("part 1/3 is there twice", {part(1, 3), part(2, 3), part(3, 3), "copy"});
  // Other settings, other inputs, another split, another table, another file.
  const std::string good = read_text(part(2, 3));
  run({"--csv", "t.csv", "--shard", "2/3", "--set", "omega=0.9"});
  expect_refused("a part of other work");
  adit({"run", "drift", "--method", "adit", "--quiet", "--csv", "t.csv", "--shard", "2/3"});
  expect_refused("a part of other work");
  write_text(part(2, 3), good);
  run({"--csv", "t.csv", "--shard", "2/4"});
  expect_refused("one of 4 parts");
  fs::remove(part(2, 4));
  expect_refused("jsonl", {part(1, 3), part(2, 3), part(3, 3), "t.jsonl.part-3-of-3"});
  expect_refused("no part of adit's", {part(1, 3), "drift/frame0.png"});
  // Cut, and changed by one letter.
  write_text(part(2, 3), good.substr(0, good.size() - 30));
  expect_refused("not whole; run --shard 2/3 again");
  std::string changed = good;
  changed[good.find("found") + 1] = 'a';
  write_text(part(2, 3), changed);
  expect_refused("changed after it was written; run --shard 2/3 again");
  write_text(part(2, 3), good);
  EXPECT_EQ(adit({"merge", "t.csv"}).exit_code, 0);
}

TEST_F(ShardedRun, WhatCannotBeJoinedIsRefusedAtOnce) {
  for (const Arguments& more : {Arguments{"--csv", "t.csv", "--shard", "0/3"},
                                {"--csv", "t.csv", "--shard", "4/3"},
                                {"--csv", "t.csv", "--shard", "1of3"},
                                {"--shard", "1/3"},
                                {"--csv", "-", "--shard", "1/3"},
                                {"--csv", "t.csv", "--video", "v.avi", "--shard", "1/3"},
                                {"--csv", "t.csv", "--limit", "3", "--shard", "1/3"},
                                {"--csv", "t.csv", "--timing", "--shard", "1/3"}}) {
    const Outcome outcome = run(more);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("--shard"), std::string::npos) << outcome.err;
  }
}

TEST(ShardedEval, GivesTheFiguresOfOneMachine) {
  const ScratchFolder folder;
  const auto adit = [&](const Arguments& arguments) { return run_adit(arguments, {.folder = folder.path()}); };
  make_passages(folder / "drift", 7);
  nlohmann::json marks;
  for (int i = 0; i < 7; ++i) {
    const int u = 100 + 8 * i;
    marks["openings"]["frame" + std::to_string(i) + ".png"] = {{u - 40, 70, u + 40, 150}};
    marks["places"]["frame" + std::to_string(i) + ".png"] = std::string(1, static_cast<char>('a' + i / 2));
  }
  write_text(folder / "drift/openings.json", marks.dump());
  const auto eval = [&](const std::string& name, const Arguments& more) {
    return adit(Arguments{"eval", "drift", "--method", "paper,adit", "--resamples", "200", "--quiet", "--json",
                          name + ".json", "--csv", name + ".csv"} +
                more);
  };
  const Outcome whole = eval("whole", {});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  for (const int count : {1, 3, 9}) {
    for (int i = 1; i <= count; ++i) {
      const Outcome shard = eval("t", {"--shard", std::to_string(i) + "/" + std::to_string(count)});
      ASSERT_EQ(shard.exit_code, 0) << shard.err;
      EXPECT_EQ(shard.out, "");
    }
    const Outcome joined = adit({"merge", "t.json", "--remove"});
    ASSERT_EQ(joined.exit_code, 0) << joined.err;
    EXPECT_EQ(joined.out, whole.out);
    EXPECT_EQ(read_text(folder / "t.json"), read_text(folder / "whole.json"));
    EXPECT_EQ(read_text(folder / "t.csv"), read_text(folder / "whole.csv"));
  }
  // Marks that were changed meanwhile.
  ASSERT_EQ(eval("t", {"--shard", "1/1"}).exit_code, 0);
  marks["openings"]["frame3.png"] = {{0, 0, 10, 10}};
  write_text(folder / "drift/openings.json", marks.dump());
  const Outcome stale = adit({"merge", "t.json"});
  EXPECT_EQ(stale.exit_code, 4);
  EXPECT_NE(stale.err.find("run the shards again"), std::string::npos) << stale.err;
}

TEST(ShardedFlights, GiveTheTableOfOneMachine) {
  if (run_adit({"fly", "--help"}).out.find("COURSE") == std::string::npos)
    GTEST_SKIP() << "this adit was built without the simulator";
  const ScratchFolder folder;
  const auto adit = [&](const Arguments& arguments) { return run_adit(arguments, {.folder = folder.path()}); };
  write_text(folder / "tiny.yaml",
             "about: Short.\npassages:\n  - to: goal\n    end: goal\n    moves:\n"
             "      - {straight_m: 12}\n");
  const auto fly = [&](const Arguments& more) {
    return adit(Arguments{"fly", "tiny.yaml", "--time", "0.3", "--runs", "7", "--method", "paper", "--set",
                          "lens.width=32", "--set", "lens.height=24", "--set", "course.cell_m=0.5"} +
                more);
  };
  const Outcome whole = fly({"--out", "whole"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  for (int i = 1; i <= 3; ++i) ASSERT_EQ(fly({"--out", "t", "--shard", std::to_string(i) + "/3"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "t/runs.csv"));
  const Outcome joined = adit({"merge", "t"});
  ASSERT_EQ(joined.exit_code, 0) << joined.err;
  EXPECT_EQ(joined.out, whole.out);
  for (const char* name : {"runs.csv", "runs.json", "seed_5/flight.csv"})
    EXPECT_EQ(read_text(folder / "t" / name), read_text(folder / "whole" / name)) << name;
  ASSERT_EQ(fly({"--out", "t", "--shard", "2/3", "--speed", "2"}).exit_code, 0);
  EXPECT_EQ(adit({"merge", "t"}).exit_code, 4);
  EXPECT_EQ(fly({"--shard", "2/3"}).exit_code, 2);
}

}  // namespace
