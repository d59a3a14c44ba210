#include "adit/node/tables.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace adit::node {
namespace {

std::string page() {
  std::ifstream file(std::string(ADIT_SOURCE_FOLDER) + "/ros/PARAMETERS.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(TablesTest, ThePageHoldsTheTopicsOfTheCode) {
  EXPECT_NE(page().find(topic_tables()), std::string::npos)
      << "cmake --build build --target ros_tables writes it again";
}

TEST(TablesTest, ThePageHoldsTheParametersOfTheCode) {
  ASSERT_NE(page().find("| finder | `omega` |"), std::string::npos);
  // Whoever changes a default of the core is not held up by a page of ROS's; the skip is seen, and the page made again.
  if (page().find(parameter_tables()) == std::string::npos)
    GTEST_SKIP() << "ros/PARAMETERS.md is older than the code: cmake --build build --target ros_tables writes it again";
}

}  // namespace
}  // namespace adit::node
