#include <exception>

#include "camera.hpp"
#include "memory.hpp"

int main(int argc, char** argv) {
  adit_ros1::keep_freed_memory();
  ros::init(argc, argv, "camera");
  try {
    adit_ros1::CameraNode node(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::spin();
    return 0;
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
}
