#include <gtest/gtest.h>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;

TEST(Config, PrintedFileGivesTheDefaultsAgain) {
  const ScratchFolder folder;
  const Outcome defaults = run_adit({"config"});
  EXPECT_EQ(defaults.exit_code, 0);
  EXPECT_EQ(defaults.err, "");
  write_text(folder / "a.yaml", defaults.out);
  EXPECT_EQ(run_adit({"config", "--config", (folder / "a.yaml").string()}).out, defaults.out);
}

TEST(Config, SettingsShowInIt) {
  const Outcome changed = run_adit({"config", "--set", "omega=0.5", "--set", "gain_per_s=2"});
  EXPECT_NE(changed.out.find("\n  omega: 0.5\n"), std::string::npos);
  EXPECT_NE(changed.out.find("\n  gain_per_s: 2\n"), std::string::npos);
}

TEST(Config, FaultsAreOneLineAndThree) {
  const ScratchFolder folder;
  const std::string bad = write_text(folder / "b.yaml", "finder:\n  omga: 1\n").string();
  const Outcome outcome = run_adit({"config", "--config", bad});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "adit: " + bad + ":2: unknown key 'omga'; did you mean 'omega'?\n");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(run_adit({"config", "--set", "omega=2"}).exit_code, 3);
}

}  // namespace
