// Prints ros/PARAMETERS.md.
#include <cstdio>

#include "adit/node/tables.hpp"

int main() {
  std::printf(
      "# Topics and parameters\n\nMade from the code: `cmake --build build --target ros_tables` writes this file "
      "again. Parameters are set by YAML or live\n(dynamic_reconfigure); their names are those of `adit config`.\n"
      "\n## Topics\n\n%s## Parameters\n\n%s",
      adit::node::topic_tables().c_str(), adit::node::parameter_tables().c_str());
}
