// The nodes' topics and parameters as tables for people: ros/PARAMETERS.md and a part of ros/adit_ros1/README.md.
#pragma once

#include <string>

namespace adit::node {

/// A topic or a service of a node. Names are as in the nodes' sources, "~" for what lies below the node's own name; a
/// test on a running graph (graph.test) compares both, either way.
struct TopicNote {
  const char* node;  ///< "open_space", "controller", "camera", "sim"
  const char* way;   ///< "in", "out", "service"
  const char* name;
  const char* type;   ///< ROS 1's spelling
  const char* where;  ///< where it is there: "always", or a condition
  const char* meaning;
};

/// Markdown, one table for each node.
[[nodiscard]] std::string topic_tables();
/// Markdown, one table for each node: name, default, unit, range, meaning and source of each field.
[[nodiscard]] std::string parameter_tables();

}  // namespace adit::node
