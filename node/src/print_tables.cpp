// Writes ros/PARAMETERS.md, and the topics' part of ros/adit_ros1/README.md: print_tables ros
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "adit/node/tables.hpp"

namespace {

std::string read(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1], readme = folder + "/adit_ros1/README.md";
  const std::string begin = "<!-- topics: made from the code -->\n", end = "<!-- end of the topics -->\n";
  std::string text = read(readme);
  const auto from = text.find(begin), to = text.find(end);
  if (from == std::string::npos || to == std::string::npos || to < from) {
    std::fprintf(stderr, "%s: the lines '%.*s' and '%.*s' are missing; put them back\n", readme.c_str(),
                 static_cast<int>(begin.size()) - 1, begin.c_str(), static_cast<int>(end.size()) - 1, end.c_str());
    return 1;
  }
  text.replace(from + begin.size(), to - from - begin.size(), "\n" + adit::node::topic_tables());
  const std::string page =
      "# Topics and parameters\n\nMade from the code: `cmake --build build --target ros_tables` writes this file "
      "again. Parameters are set by YAML or live\n(dynamic_reconfigure), those of a start alone by YAML; their names "
      "are "
      "those of `adit config`.\n\n## Topics\n\nNames that begin with ~ lie below the node's own.\n\n" +
      adit::node::topic_tables() + "## Parameters\n\n" + adit::node::parameter_tables();
  return write(readme, text) && write(folder + "/PARAMETERS.md", page) ? 0 : 1;
}
