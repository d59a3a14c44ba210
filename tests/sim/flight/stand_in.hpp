// A camera for tests: rock is as bright as an even lamp at the camera makes it, nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "adit/sim/flight.hpp"

namespace adit::sim::test {

class StandIn : public Eye {
 public:
  explicit StandIn(const RayScene& scene, int width = 80, int height = 60)
      : scene_(&scene), camera_(pinhole(width, height, 75.0)) {}

  const Camera& camera() const override { return camera_; }

  CameraPose pose(const VehicleState& vehicle) const override {
    Eigen::Matrix3d optical_to_body;
    optical_to_body << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    CameraPose pose = CameraPose::Identity();
    pose.translation() = vehicle.place;
    pose.linear() = vehicle.attitude().toRotationMatrix() * optical_to_body;
    return pose;
  }

  ImageView look(const VehicleState& vehicle, double, std::uint64_t seed) override {
    const auto ranges = range_image_m(*scene_, camera_, pose(vehicle), 100.0f);
    Random noise(seed);
    pixels_.resize(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double lit = 400.0 / std::max(1.0, static_cast<double>(ranges[i] * ranges[i])) + noise.normal();
      pixels_[i] = blind || !lamps_on_ ? std::uint8_t{0} : static_cast<std::uint8_t>(std::clamp(lit, 0.0, 255.0));
    }
    return {pixels_.data(), camera_.model().width, camera_.model().height, camera_.model().width, PixelFormat::kGrey8};
  }

  bool flashes() const override { return flash; }
  void switch_lamps(bool on) override { lamps_on_ = on; }

  bool blind = false;
  bool flash = false;

 private:
  const RayScene* scene_;
  Camera camera_;
  std::vector<std::uint8_t> pixels_;
  bool lamps_on_ = true;
};

}  // namespace adit::sim::test
