// The nodes' topics and parameters as tables for people: ros/PARAMETERS.md is made of them.
#pragma once

#include <string>

namespace adit::node {

/// A topic of a node. Names are as in the nodes' sources; a test on a running graph compares both.
struct TopicNote {
  const char* node;  ///< "open_space", "controller", "camera", "sim"
  bool is_output;
  const char* name;
  const char* type;  ///< ROS 1's spelling
  const char* meaning;
};

/// Markdown, one table for each node.
[[nodiscard]] std::string topic_tables();
/// Markdown, one table for each node: name, default, unit, range, meaning and source of each field.
[[nodiscard]] std::string parameter_tables();

}  // namespace adit::node
