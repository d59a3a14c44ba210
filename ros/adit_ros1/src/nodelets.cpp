// The nodes as nodelets: in one manager, images go from the camera to the finder without a copy.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "camera.hpp"
#include "controller.hpp"
#include "open_space.hpp"

namespace adit_ros1 {

class OpenSpaceNodelet : public nodelet::Nodelet {
  void onInit() override {
    node_ = std::make_unique<OpenSpaceNode>(getNodeHandle(), getPrivateNodeHandle(), getName());
  }
  std::unique_ptr<OpenSpaceNode> node_;
};

class ControllerNodelet : public nodelet::Nodelet {
  void onInit() override {
    node_ = std::make_unique<ControllerNode>(getNodeHandle(), getPrivateNodeHandle(), getName());
  }
  std::unique_ptr<ControllerNode> node_;
};

class CameraNodelet : public nodelet::Nodelet {
  void onInit() override { node_ = std::make_unique<CameraNode>(getNodeHandle(), getPrivateNodeHandle()); }
  std::unique_ptr<CameraNode> node_;
};

}  // namespace adit_ros1

PLUGINLIB_EXPORT_CLASS(adit_ros1::OpenSpaceNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(adit_ros1::ControllerNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(adit_ros1::CameraNodelet, nodelet::Nodelet)
