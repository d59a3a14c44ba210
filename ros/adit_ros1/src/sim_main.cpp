#include <exception>

#include "memory.hpp"
#include "sim.hpp"

int main(int argc, char** argv) {
  adit_ros1::keep_freed_memory();
  ros::init(argc, argv, "sim");
  try {
    adit_ros1::SimNode node{ros::NodeHandle(), ros::NodeHandle("~")};
    node.run();
    return 0;
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
}
