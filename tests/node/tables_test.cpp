#include "adit/node/tables.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace adit::node {
namespace {

constexpr const char* kMakeAgain = "cmake --build build --target ros_tables writes it again";

std::string page(const std::string& name) {
  std::ifstream file(std::string(ADIT_SOURCE_FOLDER) + "/ros/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// That the tables are true of running nodes is tested where they run: ros/adit_ros1/test/graph.test.
TEST(TablesTest, ThePagesHoldTheTopicsOfTheCode) {
  for (const char* name : {"PARAMETERS.md", "adit_ros1/README.md"})
    EXPECT_NE(page(name).find(topic_tables()), std::string::npos) << name << ": " << kMakeAgain;
}

TEST(TablesTest, ThePageHoldsTheParametersOfTheCode) {
  EXPECT_NE(page("PARAMETERS.md").find(parameter_tables()), std::string::npos) << kMakeAgain;
}

TEST(TablesTest, EachNodeHasItsParameters) {
  const std::string tables = parameter_tables();
  for (const char* row : {"| finder | `omega` |", "| control | `hover_after_s` |", "| launch | `body_frame` |",
                          "| launch | `freeze_after` |", "| robot | `course_file` |", "| launch | `lockstep` |"})
    EXPECT_NE(tables.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace adit::node
