#include <exception>

#include "controller.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "controller");
  try {
    adit_ros1::ControllerNode node(ros::NodeHandle(), ros::NodeHandle("~"), ros::this_node::getName());
    ros::spin();
    return 0;
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
}
