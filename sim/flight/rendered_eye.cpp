#include "adit/sim/rendered_eye.hpp"

#include <utility>

namespace adit::sim {

RigPose rig_pose_of(const VehicleState& vehicle) {
  RigPose pose;
  pose.place = vehicle.place.cast<float>();
  pose.attitude = vehicle.attitude().cast<float>();
  pose.velocity_m_s = vehicle.velocity.cast<float>();
  pose.angular_rate_rad_s = vehicle.angular_rate().cast<float>();
  return pose;
}

RenderedEye::RenderedEye(const World& world, const RigConfig& rig, const RenderConfig& render,
                         std::shared_ptr<const RayScene> scene)
    : renderer_(world, rig, render, std::move(scene)), exposure_(rig.sensor) {}

const Camera& RenderedEye::camera() const { return renderer_.camera(); }

CameraPose RenderedEye::pose(const VehicleState& vehicle) const {
  return renderer_.camera_pose(rig_pose_of(vehicle)).cast<double>();
}

ImageView RenderedEye::look(const VehicleState& vehicle, double stamp_s, std::uint64_t seed) {
  if (lamps_on_ && lit_level_) {
    exposure_.observe(*lit_level_);
    lit_level_.reset();
  }
  renderer_.render({rig_pose_of(vehicle), exposure_.current(), stamp_s, seed, lamps_on_}, frame_);
  if (!flashes())
    exposure_.observe(frame_.mean_level);
  else if (lamps_on_)
    lit_level_ = frame_.mean_level;
  return frame_.view();
}

}  // namespace adit::sim
