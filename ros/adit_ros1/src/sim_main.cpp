#include <exception>

#include "sim.hpp"

int main(int argc, char** argv) {
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
