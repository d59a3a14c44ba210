#include "file_lists.hpp"

#include <gtest/gtest.h>

#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::io;
using adit::testing::ScratchFolder;
using adit::testing::write_text;

std::vector<std::string> file_names(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(path.filename().string());
  return names;
}
using Names = std::vector<std::string>;

TEST(FileLists, NumbersCompareAsNumbers) {
  EXPECT_TRUE(natural_less("frame2", "frame10"));
  EXPECT_FALSE(natural_less("frame10", "frame2"));
  EXPECT_TRUE(natural_less("a9b1", "a9b02"));
  EXPECT_TRUE(natural_less("run1-2.png", "run1-10.png"));
  EXPECT_TRUE(natural_less("99999999999999999999998", "99999999999999999999999"));
  EXPECT_TRUE(natural_less("a", "ab"));
  EXPECT_TRUE(natural_less("1", "a"));
  EXPECT_FALSE(natural_less("a1", "a1"));
  EXPECT_NE(natural_less("a01", "a1"), natural_less("a1", "a01"));
}

TEST(FileLists, FolderGivesItsImagesOnly) {
  const ScratchFolder folder;
  for (const char* name : {"f10.png", "f2.PNG", "f1.jpg", ".hidden.png", "notes.txt", "f3.json"}) {
    write_text(folder / name, "x");
  }
  std::filesystem::create_directory(folder / "f0.png");
  EXPECT_EQ(file_names(images_of_folder(folder.path())), (Names{"f1.jpg", "f2.PNG", "f10.png"}));
}

TEST(FileLists, FolderWithoutImagesIsRefused) {
  const ScratchFolder folder;
  write_text(folder / "notes.txt", "x");
  EXPECT_THROW((void)images_of_folder(folder.path()), InputError);
}

TEST(FileLists, PatternsAreExpandedInNaturalOrder) {
  const ScratchFolder folder;
  for (const char* name : {"f10.png", "f2.png", "g1.png", "f3.json", "f1.mp4"}) write_text(folder / name, "x");
  EXPECT_EQ(file_names(matches_of((folder / "f*").string())), (Names{"f1.mp4", "f2.png", "f10.png"}));
  EXPECT_EQ(file_names(matches_of((folder / "?[12].png").string())), (Names{"f2.png", "g1.png"}));
  EXPECT_THROW((void)matches_of((folder / "*.bmp").string()), InputError);
  EXPECT_THROW((void)matches_of((folder / "*.json").string()), InputError);
}

}  // namespace
