// `adit run /dev/video0`, down to the system calls of Video4Linux, which a library that is preloaded answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;

/// What is told to the stand-in, and the stand-in itself, for the programs that are started meanwhile.
class Camera : public ::testing::Test {
 protected:
  void SetUp() override { tell("LD_PRELOAD", ADIT_STAND_IN); }
  void TearDown() override {
    for (const char* name : {"LD_PRELOAD", "ADIT_STAND_IN_UNPLUG_AFTER", "ADIT_STAND_IN_IS_METADATA"}) ::unsetenv(name);
  }
  static void tell(const char* name, const char* value) { ::setenv(name, value, 1); }
};

std::size_t column(const std::vector<std::string>& head, const std::string& name) {
  return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
}

TEST_F(Camera, ItsFramesAreJudgedAtTheirTimes) {
  const Outcome run = run_adit({"run", "/dev/video0", "--method", "paper", "--limit", "20", "--csv", "-", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 21u);
  const std::size_t stamp = column(rows[0], "stamp_s"), status = column(rows[0], "status"), u = column(rows[0], "u_px"),
                    v = column(rows[0], "v_px");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][status], "found");
    // The disc's middle is between 220 and 420, in row 220.
    EXPECT_NEAR(std::stod(rows[i][u]), 320.0, 105.0);
    EXPECT_NEAR(std::stod(rows[i][v]), 220.0, 4.0);
    if (i > 1) {
      EXPECT_GT(std::stod(rows[i][stamp]), std::stod(rows[i - 1][stamp]));
    }
  }
  // It goes to the right at first; 19 periods of 1/30 s pass, or more where the machine is busy.
  EXPECT_GT(std::stod(rows[5][u]), std::stod(rows[1][u]) + 5.0);
  EXPECT_GT(std::stod(rows[20][stamp]), 0.5);
}

TEST_F(Camera, UnpluggedMeanwhileIsToldAndTheTableIsWhole) {
  tell("ADIT_STAND_IN_UNPLUG_AFTER", "5");
  const ScratchFolder folder;
  const std::string table = (folder / "answers.csv").string();
  const Outcome run = run_adit({"run", "/dev/video0", "--method", "adit", "--csv", table, "--quiet"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_EQ(run.err, "adit: /dev/video0: the camera gave no more frames; unplugged?\n");
  EXPECT_TRUE(std::filesystem::exists(table));
}

TEST_F(Camera, ADeviceThatGivesNoPicturesIsRefused) {
  tell("ADIT_STAND_IN_IS_METADATA", "1");
  const Outcome run = run_adit({"run", "/dev/video0", "--csv", "-"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(run.err, "adit: /dev/video0: not a camera that gives pictures (Video4Linux)\n");
}

TEST_F(Camera, ViewRefusesWhatIsNoCameraBeforeItPromisesAPage) {
  tell("ADIT_STAND_IN_IS_METADATA", "1");
  const Outcome view = run_adit({"view", "/dev/video0"});
  EXPECT_EQ(view.exit_code, 4);
  EXPECT_EQ(view.out, "");
  EXPECT_EQ(view.err, "adit: /dev/video0: not a camera that gives pictures (Video4Linux)\n");
  EXPECT_EQ(run_adit({"view", "/dev/video731"}).err, "adit: /dev/video731: no such camera; is it plugged in?\n");
}

}  // namespace
