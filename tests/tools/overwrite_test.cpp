// What is read is never written over, whatever the subcommand and however the file is named.
#include <gtest/gtest.h>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
namespace fs = std::filesystem;

class Overwrite : public ::testing::Test {
 protected:
  Overwrite() {
    make_passages(scratch_ / "im", 2);
    fs::copy(scratch_ / "im/frame0.png", scratch_ / "a.png");
    fs::create_directory(scratch_ / "S");
    fs::copy(scratch_ / "im/frame0.png", scratch_ / "S/f.png");
    write_text(scratch_ / "S/openings.json", R"({"openings": {"f.png": [[80, 90, 120, 130]]}})");
    write_text(scratch_ / "c.yaml", "finder:\n  omega: 0.9\n");
    write_text(scratch_ / "t.csv", "source,u_px,v_px\nf.png,100,110\n");
    fs::create_symlink("a.png", scratch_ / "link.png");
    fs::create_hard_link(scratch_ / "c.yaml", scratch_ / "hard.csv");
  }

  /// Two, one line that names both, and every file as it was.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& written, const std::string& read) {
    const auto before = contents();
    const Outcome outcome = run_adit(arguments, {.folder = scratch_.path()});
    std::string command;
    for (const std::string& argument : arguments) command += argument + " ";
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << command << outcome.err;
    EXPECT_NE(outcome.err.find(written), std::string::npos) << command << outcome.err;
    EXPECT_NE(outcome.err.find(read), std::string::npos) << command << outcome.err;
    EXPECT_EQ(contents(), before) << command;
  }

  std::vector<std::pair<std::string, std::string>> contents() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path()))
      all.emplace_back(entry.path().string(), entry.is_regular_file() ? read_text(entry.path()) : "");
    std::sort(all.begin(), all.end());
    return all;
  }

  const ScratchFolder scratch_;
};

TEST_F(Overwrite, Run) {
  expect_refused({"run", "a.png", "--config", "c.yaml", "--csv", "c.yaml"}, "--csv: c.yaml", "(--config)");
  expect_refused({"run", "a.png", "--config", "c.yaml", "--csv", "hard.csv"}, "--csv: hard.csv", "(--config)");
  expect_refused({"run", "a.png", "--camera", "c.yaml", "--jsonl", "./im/../c.yaml"}, "--jsonl", "(--camera)");
  expect_refused({"run", "a.png", "--lamp", "c.yaml", "--learn-lamp", "c.yaml"}, "--learn-lamp", "(--lamp)");
  expect_refused({"run", "a.png", "--sequence", "--learn-lamp", "a.png"}, "--learn-lamp", "(INPUT)");
  expect_refused({"run", "link.png", "--report", "a.png"}, "--report", "link.png");
  expect_refused({"run", "im", "--csv", "im/frame1.png"}, "--csv", "im/frame1.png");
  expect_refused({"run", "im/*.png", "--csv", "im/frame1.png"}, "--csv", "im/frame1.png");
  expect_refused({"run", "im/*{0,1}.png", "--csv", "im/frame1.png"}, "--csv", "im/frame1.png");
  expect_refused({"run", "im", "--frames", "im/"}, "--frames: im/", "im");
  expect_refused({"run", "im/frame0.png", "--frames", "im"}, "--frames: im", "im/frame0.png");
  expect_refused({"run", "im", "--out", "im"}, "--out: im", "im");
}

TEST_F(Overwrite, OthersThatJudge) {
  expect_refused({"explain", "a.png", "-o", "a.png"}, "--output: a.png", "(IMAGE)");
  expect_refused({"explain", "a.png", "-o", "link.png"}, "--output: link.png", "(IMAGE)");
  expect_refused({"bench", "--input", "a.png", "--json", "./a.png"}, "--json: ./a.png", "(--input)");
  expect_refused({"eval", "S", "--json", "S/openings.json"}, "--json: S/openings.json", "(DATASET)");
  expect_refused({"eval", "S", "--csv", "S/f.png"}, "--csv: S/f.png", "(DATASET)");
  expect_refused({"eval", "S", "--gallery", "S"}, "--gallery: S", "DATASET");
  expect_refused({"eval", "S", "--table", "t=t.csv", "--csv", "t.csv"}, "--csv: t.csv", "(--table)");
}

TEST_F(Overwrite, WhatIsMadeOfRunsAndParts) {
  ASSERT_EQ(run_adit({"run", "a.png", "--out", "r", "--quiet"}, {.folder = scratch_.path()}).exit_code, 0);
  expect_refused({"report", "r", "-o", "r/headings.csv"}, "--out: r/headings.csv", "(RUN_DIR)");
  expect_refused({"report", "r", "-o", "a.png"}, "--out: a.png", "a.png");
  ASSERT_EQ(run_adit({"run", "a.png", "--shard", "1/1", "--csv", "p.csv"}, {.folder = scratch_.path()}).exit_code, 0);
  expect_refused({"merge", "p.csv.part-1-of-1", "p.csv.part-1-of-1"}, "WHOLE: p.csv.part-1-of-1", "(PART)");
}

#ifdef ADIT_WITH_SIM
TEST_F(Overwrite, Simulation) {
  fs::create_directory(scratch_ / "d");
  write_text(scratch_ / "d/settings.yaml", "dust:\n");
  write_text(scratch_ / "w.world", "<sdf/>");
  write_text(scratch_ / "p.csv", "x_m,y_m,z_m\n");
  expect_refused({"fly", "--world", "w.world", "--start", "0,0,0,0", "--report", "w.world"}, "--report", "(--world)");
  expect_refused({"fly", "s_bend", "--config", "c.yaml", "--bag", "c.yaml"}, "--bag: c.yaml", "(--config)");
  expect_refused({"fly", "s_bend", "--config", "d/settings.yaml", "--out", "d"}, "--out: d/settings.yaml",
                 "(--config)");
  expect_refused({"render", "s_bend", "--config", "d/settings.yaml", "--out", "d"}, "--out: d/settings.yaml",
                 "(--config)");
  fs::rename(scratch_ / "p.csv", scratch_ / "d/truth.csv");
  expect_refused({"render", "s_bend", "--poses", "d/truth.csv", "--out", "d"}, "--out: d/truth.csv", "(--poses)");
}
#endif

TEST_F(Overwrite, WhatIsOnlyBesideIsWritten) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"run", "im", "--csv", "im/table.csv"},
           {"run", "im", "--csv", "im/table.csv"},  // the older table is no input
           {"run", "im", "--frames", "im/overlays", "--out", "r"},
           {"run", "im", "--csv", "/dev/null", "--jsonl", "/dev/null"},
           {"eval", "S", "--no-baselines", "--resamples", "100", "--csv", "S/figures.csv", "--gallery", "S/g.html"}})
    EXPECT_EQ(run_adit(arguments, {.folder = scratch_.path()}).exit_code, 0) << arguments.back();
}

}  // namespace
