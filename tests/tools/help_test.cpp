#include <gtest/gtest.h>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;

/// The subcommands that the main help lists.
std::vector<std::string> subcommands() {
  std::vector<std::string> names;
  bool listing = false;
  for (const std::string& line : lines_of(run_adit({"--help"}).out)) {
    if (line == "Subcommands:") listing = true;
    if (listing && line.starts_with("  ") && line.size() > 2 && line[2] != ' ') {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

TEST(Help, EveryPageFitsOneScreenAndEndsWithAnExample) {
  std::vector<std::vector<std::string>> pages{{"--help"}};
  for (const std::string& name : subcommands()) pages.push_back({name, "--help"});
  ASSERT_GE(pages.size(), 3u);
  for (const auto& arguments : pages) {
    const Outcome help = run_adit(arguments);
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    const auto lines = lines_of(help.out);
    EXPECT_LE(lines.size(), 36u) << arguments[0];
    for (const std::string& line : lines) EXPECT_LE(line.size(), 100u) << line;
    EXPECT_EQ(help.out.find("\n\n\n"), std::string::npos) << arguments[0] << ": two blank lines";
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(lines.back().starts_with("Example: adit ")) << lines.back();
  }
}

/// Splits a command at blanks, up to a redirection.
std::vector<std::string> arguments_of(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : command + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      if (word == ">") break;
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}

TEST(Help, ExamplesRun) {
  if (!std::filesystem::exists(ADIT_SOURCE_FOLDER "/data/clip.avi")) GTEST_SKIP() << "data/clip.avi is not there yet";
  std::vector<std::vector<std::string>> pages{{"--help"}};
  for (const std::string& name : subcommands()) pages.push_back({name, "--help"});
  for (const auto& page : pages) {
    const std::string example = lines_of(run_adit(page).out).back();
    const ScratchFolder folder;
    std::filesystem::create_directory_symlink(ADIT_SOURCE_FOLDER "/data", folder / "data");
    auto arguments = arguments_of(example.substr(std::string("Example: adit ").size()));
    // Their examples are meant to take their time; tests of their own run them.
    if (page[0] == "bench" || page[0] == "fly" || page[0] == "render" || page[0] == "mark" || page[0] == "report" ||
        page[0] == "view" || page[0] == "gz")
      continue;
    // What it joins has to be there.
    if (page[0] == "merge") {
      const std::vector<std::string> part{"run", "data/clip.avi", "--shard", "1/1", "--csv", "headings.csv"};
      EXPECT_EQ(run_adit(part, {.folder = folder.path()}).exit_code, 0);
    }
    const Outcome outcome = run_adit(arguments, {.folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << example << "\n" << outcome.err;
  }
}

TEST(Help, Version) {
  const Outcome version = run_adit({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.out.starts_with("adit ")) << version.out;
}

TEST(Help, WrongUsageIsOneLineAndTwo) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"bogus"},
                                             {"--bogus"},
                                             {"run"},
                                             {"run", "--bogus", "x.png"},
                                             {"run", "x.png", "--jobs", "0"},
                                             {"run", "x.png", "--jobs", "two"},
                                             {"run", "x.png", "--fps", "0"},
                                             {"run", "x.png", "--fps", "nan"},
                                             {"bench", "--seconds", "nan"},
                                             {"bench", "--target", "foo"},
                                             {"run", "x.png", "--limit", "-1"},
                                             {"run", "x.png", "--method", "magic"},
                                             {"run", "x.png", "--csv", "-", "--jsonl", "-"},
                                             {"run", "x.png", "--csv", "t", "--jsonl", "./t"},
                                             {"run", "x.png", "--csv", "x.png"}}) {
    const Outcome outcome = run_adit(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("adit: ")) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
