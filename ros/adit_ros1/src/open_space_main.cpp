#include <exception>

#include "memory.hpp"
#include "open_space.hpp"

int main(int argc, char** argv) {
  adit_ros1::keep_freed_memory();
  ros::init(argc, argv, "open_space");
  try {
    adit_ros1::OpenSpaceNode node(ros::NodeHandle(), ros::NodeHandle("~"), ros::this_node::getName());
    ros::spin();
    return 0;
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
}
