// Camera models of any figures: refused with a reason, or usable without a crash for every pixel.
// Input: width, height (int16), model (uint8), fx, fy, ox, oy, eight distortion figures, u, v (float).
#include "adit/camera.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "byte_source.hpp"

namespace {

using adit::fuzz::require;

adit::CameraModel model_of(adit::fuzz::ByteSource& source) {
  adit::CameraModel model;
  model.width = source.take<std::int16_t>();
  model.height = source.take<std::int16_t>();
  model.distortion_model = static_cast<adit::DistortionModel>(source.take<std::uint8_t>() % 5);  // 4 is none of them
  model.focal_length_x_px = static_cast<double>(source.take<float>());
  model.focal_length_y_px = static_cast<double>(source.take<float>());
  model.principal_point_x_px = static_cast<double>(source.take<float>());
  model.principal_point_y_px = static_cast<double>(source.take<float>());
  for (double& figure : model.distortion) figure = static_cast<double>(source.take<float>());
  return model;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  adit::fuzz::ByteSource source(bytes, size);
  const adit::CameraModel model = model_of(source);
  const bool refused = fault_of(model).has_value();
  try {
    const adit::Camera camera(model);
    require(!refused, "a model with a fault is refused");
    const adit::Pixel pixel{static_cast<double>(source.take<float>()), static_cast<double>(source.take<float>())};
    const adit::Bearing bearing = camera.bearing_of(pixel);
    if (std::isfinite(pixel.u_px) && std::isfinite(pixel.v_px)) {
      require(!(std::abs(bearing.azimuth_rad) > std::numbers::pi), "azimuth is in (-pi, pi]");
      require(!(std::abs(bearing.elevation_rad) > std::numbers::pi / 2), "elevation is in [-pi/2, pi/2]");
    }
    (void)camera.pixel_of(camera.normalised_of(pixel));
    (void)camera.pixel_of(bearing);
  } catch (const std::invalid_argument&) {
    require(refused, "a model without a fault is accepted");
  }
  return 0;
}
