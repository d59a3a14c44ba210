// The rendered camera as what the vehicle looks through.
#pragma once

#include <memory>
#include <optional>

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
  /// With lamps that flash, exposure follows the frames with the lamps on, and is the same in the frame after.
  ImageView look(const VehicleState& vehicle, double stamp_s, std::uint64_t seed) override;
  [[nodiscard]] bool flashes() const override { return renderer_.rig().lamps.flash; }
  void switch_lamps(bool on) override { lamps_on_ = on; }
  void both(const std::function<void()>& one, const std::function<void()>& other) override {
    renderer_.both(one, other);
  }

  /// The last frame, with range and exposure.
  [[nodiscard]] const Frame& frame() const noexcept { return frame_; }

 private:
  Renderer renderer_;
  AutoExposure exposure_;
  Frame frame_;
  bool lamps_on_ = true;
  std::optional<float> lit_level_;  ///< mean of the last frame with the lamps on that exposure has not followed yet
};

/// A vehicle's motion as the renderer takes it.
[[nodiscard]] RigPose rig_pose_of(const VehicleState& vehicle);

}  // namespace adit::sim
