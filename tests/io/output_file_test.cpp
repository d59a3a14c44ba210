#include "adit/io/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::io;
using adit::testing::message_of;
using adit::testing::read_text;
using adit::testing::ScratchFolder;
using adit::testing::write_text;
using Names = std::vector<std::string>;

TEST(OutputFile, AppearsWholeAndOnlyAtCommit) {
  const ScratchFolder folder;
  OutputFile file(folder / "t.csv");
  file.write("one\n");
  file.write(std::string(200000, 'x'));
  EXPECT_FALSE(std::filesystem::exists(folder / "t.csv"));
  file.commit();
  EXPECT_EQ(read_text(folder / "t.csv"), "one\n" + std::string(200000, 'x'));
  EXPECT_EQ(folder.names(), Names{"t.csv"});
}

TEST(OutputFile, WithoutCommitTheOldFileStaysAndNothingElse) {
  const ScratchFolder folder;
  write_text(folder / "t.csv", "old");
  {
    OutputFile file(folder / "t.csv");
    file.write(std::string(200000, 'x'));
  }
  EXPECT_EQ(read_text(folder / "t.csv"), "old");
  EXPECT_EQ(folder.names(), Names{"t.csv"});
}

TEST(OutputFile, LinksStayLinks) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "deep");
  write_text(folder / "deep/real.csv", "old");
  std::filesystem::create_symlink("deep/real.csv", folder / "t.csv");
  write_file(folder / "t.csv", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "t.csv"));
  EXPECT_EQ(read_text(folder / "deep/real.csv"), "new");
}

TEST(OutputFile, ModeFollowsTheMask) {
  const ScratchFolder folder;
  const mode_t old = ::umask(0027);
  write_file(folder / "t.csv", "x");
  ::umask(old);
  struct stat status {};
  ASSERT_EQ(::stat((folder / "t.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(OutputFile, DevicesAreWrittenAndNeverReplaced) {
  write_file("/dev/null", "x");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(message_of<OutputError>([] { write_file("/dev/full", "x"); }),
            "/dev/full: cannot be written: No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(OutputFile, PlacesThatCannotBeAreRefusedAtOnce) {
  const ScratchFolder folder;
  const auto why = [](const std::filesystem::path& path) {
    return message_of<OutputError>([&] { const OutputFile file(path); });
  };
  EXPECT_NE(why(folder / "no/t.csv").find("no such folder: " + (folder / "no").string()), std::string::npos);
  EXPECT_NE(why(folder.path()).find("it is a folder"), std::string::npos);
  EXPECT_NE(why(""), "");
  write_text(folder / "file", "x");
  EXPECT_NE(why(folder / "file/t.csv"), "");
  EXPECT_EQ(folder.names(), Names{"file"});
}

}  // namespace
