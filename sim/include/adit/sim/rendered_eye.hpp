// The rendered camera as what the vehicle looks through.
#pragma once

#include <memory>

#include "adit/sim/flight.hpp"
#include "adit/sim/render.hpp"

namespace adit::sim {

/// Renderer and automatic exposure. One flight each; several may share a scene.
class RenderedEye : public Eye {
 public:
  /// @param world  must outlive the eye. @throws as Renderer does.
  RenderedEye(const World& world, const RigConfig& rig, const RenderConfig& render,
              std::shared_ptr<const RayScene> scene);

  [[nodiscard]] const Camera& camera() const override;
  [[nodiscard]] CameraPose pose(const VehicleState& vehicle) const override;
  ImageView look(const VehicleState& vehicle, double stamp_s, std::uint64_t seed) override;

  /// The last frame, with range and exposure.
  [[nodiscard]] const Frame& frame() const noexcept { return frame_; }

 private:
  Renderer renderer_;
  AutoExposure exposure_;
  Frame frame_;
};

/// A vehicle's motion as the renderer takes it.
[[nodiscard]] RigPose rig_pose_of(const VehicleState& vehicle);

}  // namespace adit::sim
