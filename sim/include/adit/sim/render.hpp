// World + rig + pose + seed -> the frame the robot's camera delivers, and the range behind every pixel.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "adit/camera.hpp"
#include "adit/image.hpp"
#include "adit/sim/dust.hpp"
#include "adit/sim/lamp_rig.hpp"
#include "adit/sim/scene.hpp"
#include "adit/sim/sensor.hpp"
#include "adit/sim/world.hpp"

namespace adit::sim {

/// How much work goes into a frame. It changes the picture; nothing here changes the truth.
struct RenderConfig {
  int threads = 0;                ///< 0: all of the machine; the bytes do not depend on it
  int virtual_lights = 16;        ///< points of light that stand for light reflected once by rock; 0: none
  float indirect_clamp_m = 0.7f;  ///< virtual lights come no closer than this
  bool shadows = true;
  bool facets = true;  ///< facets and patches finer than the mesh
  bool motion_blur = true;
  bool sensor_noise = true;
  float foreign_red = 1.20f;  ///< colour of lamps in the world, relative to green
  float foreign_blue = 0.70f;
  float cull_fraction = 2e-4f;  ///< lamps that add less than this share of white to a tile are passed over there
};

/// All that sits on the vehicle, and the air around it.
struct RigConfig {
  std::string name = "one_lamp";
  LampRig lamps;
  LensConfig lens;
  SensorConfig sensor;
  DustConfig dust;
  DirtConfig dirt;
};

/// Names of the rigs that come with the project: flood_460lux, dim_40lux, narrow_beam, subt_x3.
[[nodiscard]] const std::vector<std::string>& rig_preset_names();
/// @throws std::invalid_argument naming the rigs there are.
[[nodiscard]] RigConfig rig_preset(std::string_view name);

/// Why a rig cannot be built, naming the field, the value and the range; empty when it can.
[[nodiscard]] std::string fault_of(const RigConfig& rig);

/// Where the vehicle is in the middle of the exposure, and how it moves.
struct RigPose {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();               ///< of the body, world frame, m
  Eigen::Quaternionf attitude = Eigen::Quaternionf::Identity();  ///< body (x forward, y left, z up) to world
  Eigen::Vector3f velocity_m_s = Eigen::Vector3f::Zero();        ///< world frame
  Eigen::Vector3f angular_rate_rad_s = Eigen::Vector3f::Zero();  ///< body frame
};

/// One press of the shutter.
struct Shot {
  RigPose pose;
  Exposure exposure;
  double time_s = 0.0;     ///< of the flight: grains drift by it
  std::uint64_t seed = 0;  ///< of this frame: noise is drawn by it
  bool lamps_on = true;    ///< those of the rig
};

/// Milliseconds of the last frame by part, wall clock.
struct RenderTimes {
  double light_ms = 0.0;   ///< rays and shading
  double lens_ms = 0.0;    ///< emitters, glare, grains, motion blur
  double sensor_ms = 0.0;  ///< noise, colour, tone
  double jpeg_ms = 0.0;
};

/// What the camera delivers, and what only the simulator knows.
struct Frame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgr;  ///< rows without padding
  std::vector<float> range_m;     ///< along each pixel's ray in the middle of the exposure; 1e9 where it leaves
  float mean_level = 0.0f;        ///< of the bytes, 0 to 255
  Exposure exposure;
  RenderTimes times;

  [[nodiscard]] ImageView view() const noexcept {
    return {bgr.data(), width, height, std::ptrdiff_t{3} * width, PixelFormat::kBgr8};
  }
};

/// Linear light in front of the sensor, for tests and for other sensors.
struct Radiance {
  int width = 0;
  int height = 0;
  std::vector<float> red, green, blue;  ///< cd/m^2, rows without padding
};

inline constexpr float kRangeOfNothing_m = 1e9f;

/// Draws frames of one world with one rig. One call at a time on one object; several objects may share a scene.
class Renderer {
 public:
  /// @param world must outlive the renderer. @param scene of world.mesh; built here where null.
  /// @throws std::invalid_argument with fault_of(rig), or as RayScene does.
  Renderer(const World& world, const RigConfig& rig, const RenderConfig& render = {},
           std::shared_ptr<const RayScene> scene = nullptr);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The same shot gives the same bytes, whatever the number of threads.
  void render(const Shot& shot, Frame& frame);
  [[nodiscard]] Frame render(const Shot& shot);
  /// As render, without lens blur, vignetting and sensor.
  [[nodiscard]] Radiance radiance(const Shot& shot);

  [[nodiscard]] const RayScene& scene() const noexcept;
  [[nodiscard]] std::shared_ptr<const RayScene> shared_scene() const noexcept;
  [[nodiscard]] const Camera& camera() const noexcept;
  [[nodiscard]] const RigConfig& rig() const noexcept;
  /// Does both on the renderer's threads, beside each other where there are two.
  void both(const std::function<void()>& one, const std::function<void()>& other) const;
  /// Place of the lens in the world, and the rotation from the optical frame (x right, y down, z forward) to it.
  [[nodiscard]] Eigen::Isometry3f camera_pose(const RigPose& pose) const;

  struct Parts;  ///< of the passes, in sim/light/parts.hpp

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace adit::sim
