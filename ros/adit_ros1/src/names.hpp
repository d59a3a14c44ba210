// Where a node's topics lie.
#pragma once

#include <ros/names.h>
#include <ros/node_handle.h>

#include <string>

namespace adit_ros1 {

/// A name beside the node, whole: /image of /open_space, /left/image of /left/open_space. For nodelets, roscpp's own
/// NodeHandle is not enough: in a manager that has a namespace, it looks for the topics (and for the remappings) of a
/// nodelet that has none below the manager's, and no image comes.
inline std::string name_beside(const ros::NodeHandle& private_nh, const std::string& name) {
  return ros::names::append(ros::names::parentNamespace(private_nh.getNamespace()), name);
}

}  // namespace adit_ros1
