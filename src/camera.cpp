#include "adit/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "adit/image.hpp"
#include "distortion.hpp"
#include "number_text.hpp"

namespace adit {
namespace {

constexpr double kFocalLengthMin_px = 1.0;
constexpr double kFocalLengthMax_px = 1e6;
constexpr double kCoefficientMax = 1e6;
constexpr double kPlaneAngleMax_rad = 89.0 * std::numbers::pi / 180.0;  // the plane z = 1 ends at 90 deg

bool in_range(double value, double minimum, double maximum) noexcept { return value >= minimum && value <= maximum; }

std::optional<std::string> fault_in(const std::string& name, double value, double minimum, double maximum,
                                    const std::string& unit) {
  if (in_range(value, minimum, maximum)) return std::nullopt;
  return range_fault(name, value, minimum, maximum, unit);
}

/// The pixel's point before the lens is undone.
NormalisedPoint seen_at(const CameraModel& m, Pixel pixel) noexcept {
  return {(pixel.u_px - m.principal_point_x_px) / m.focal_length_x_px,
          (pixel.v_px - m.principal_point_y_px) / m.focal_length_y_px};
}

bool is_equidistant(const CameraModel& m) noexcept { return m.distortion_model == DistortionModel::kEquidistant; }

}  // namespace

CameraModel pinhole(int width, int height, double hfov_deg) {
  if (!in_range(hfov_deg, 10.0, 170.0)) throw std::invalid_argument(range_fault("hfov_deg", hfov_deg, 10, 170, "deg"));
  CameraModel model;
  model.width = width;
  model.height = height;
  model.focal_length_x_px = 0.5 * width / std::tan(0.5 * hfov_deg * std::numbers::pi / 180.0);
  model.focal_length_y_px = model.focal_length_x_px;
  model.principal_point_x_px = 0.5 * (width - 1);
  model.principal_point_y_px = 0.5 * (height - 1);
  if (const auto fault = fault_of(model)) throw std::invalid_argument(*fault);
  return model;
}

CameraModel resized(const CameraModel& model, int width, int height) {
  const double x = static_cast<double>(width) / model.width;
  const double y = static_cast<double>(height) / model.height;
  CameraModel out = model;
  out.width = width;
  out.height = height;
  out.focal_length_x_px *= x;
  out.focal_length_y_px *= y;
  // Pixel centres are at integers, so the frame's left edge, which stays where it is, is at -0.5.
  out.principal_point_x_px = (model.principal_point_x_px + 0.5) * x - 0.5;
  out.principal_point_y_px = (model.principal_point_y_px + 0.5) * y - 0.5;
  return out;
}

int coefficient_count(DistortionModel model) noexcept {
  switch (model) {
    case DistortionModel::kNone:
      return 0;
    case DistortionModel::kPlumbBob:
      return 5;
    case DistortionModel::kRationalPolynomial:
      return 8;
    case DistortionModel::kEquidistant:
      return 4;
  }
  return 0;
}

std::optional<std::string> fault_of(const CameraModel& m) {
  std::optional<std::string> fault;
  const auto check = [&fault](const std::string& name, double value, double minimum, double maximum,
                              const std::string& unit) {
    if (!fault) fault = fault_in(name, value, minimum, maximum, unit);
  };
  check("width", m.width, kSideMin_px, kSideMax_px, "px");
  check("height", m.height, kSideMin_px, kSideMax_px, "px");
  check("focal_length_x_px", m.focal_length_x_px, kFocalLengthMin_px, kFocalLengthMax_px, "px");
  check("focal_length_y_px", m.focal_length_y_px, kFocalLengthMin_px, kFocalLengthMax_px, "px");
  check("principal_point_x_px", m.principal_point_x_px, -m.width, 2.0 * m.width, "px");
  check("principal_point_y_px", m.principal_point_y_px, -m.height, 2.0 * m.height, "px");
  if (!fault && (m.distortion_model < DistortionModel::kNone || m.distortion_model > DistortionModel::kEquidistant)) {
    fault = "distortion_model: " + std::to_string(static_cast<int>(m.distortion_model)) +
            " is not known; set none, plumb_bob, rational_polynomial or equidistant";
  }
  for (int i = 0; i < coefficient_count(m.distortion_model); ++i) {
    check("distortion[" + std::to_string(i) + "]", m.distortion[static_cast<std::size_t>(i)], -kCoefficientMax,
          kCoefficientMax, "");
  }
  return fault;
}

Camera::Camera(const CameraModel& model) : model_(model) {
  if (const auto fault = fault_of(model)) throw std::invalid_argument(*fault);
  radius_max_ = growing_radius_max(model_);
}

NormalisedPoint Camera::normalised_of(Pixel pixel) const noexcept {
  const NormalisedPoint seen = seen_at(model_, pixel);
  if (model_.distortion_model == DistortionModel::kNone) return seen;
  const NormalisedPoint point = undistorted(model_, radius_max_, seen);
  if (!is_equidistant(model_)) return point;
  const double theta = std::hypot(point.sx, point.sy);
  if (theta == 0.0) return point;
  const double scale = std::tan(std::min(theta, kPlaneAngleMax_rad)) / theta;
  return {point.sx * scale, point.sy * scale};
}

Pixel Camera::pixel_of(NormalisedPoint point) const noexcept {
  if (is_equidistant(model_)) {
    const double radius = std::hypot(point.sx, point.sy);
    const double scale = radius > 0.0 ? std::atan(radius) / radius : 1.0;
    point = {point.sx * scale, point.sy * scale};
  }
  const NormalisedPoint seen = distorted(model_, point);
  return {seen.sx * model_.focal_length_x_px + model_.principal_point_x_px,
          seen.sy * model_.focal_length_y_px + model_.principal_point_y_px};
}

Bearing Camera::bearing_of(Pixel pixel) const noexcept {
  if (!is_equidistant(model_)) return adit::bearing_of(normalised_of(pixel));
  const NormalisedPoint angle = undistorted(model_, radius_max_, seen_at(model_, pixel));
  const double theta = std::hypot(angle.sx, angle.sy);
  const double scale = theta > 0.0 ? std::sin(theta) / theta : 1.0;
  const double x = angle.sx * scale;
  const double y = angle.sy * scale;
  const double z = std::cos(theta);
  return {std::atan2(x, z), std::atan2(-y, std::hypot(x, z))};
}

std::optional<Pixel> Camera::pixel_of(Bearing bearing) const noexcept {
  const auto point = adit::normalised_of(bearing);
  if (!point) return std::nullopt;
  return pixel_of(*point);
}

Bearing bearing_of(NormalisedPoint point) noexcept {
  // 0 - y and not -y: straight ahead is elevation 0 and not -0.
  return {std::atan(point.sx), std::atan2(0.0 - point.sy, std::hypot(point.sx, 1.0))};
}

std::optional<NormalisedPoint> normalised_of(Bearing bearing) noexcept {
  constexpr double kRightAngle_rad = 0.5 * std::numbers::pi;
  if (!(std::abs(bearing.azimuth_rad) < kRightAngle_rad && std::abs(bearing.elevation_rad) < kRightAngle_rad)) {
    return std::nullopt;
  }
  const double sx = std::tan(bearing.azimuth_rad);
  return NormalisedPoint{sx, 0.0 - std::tan(bearing.elevation_rad) * std::hypot(sx, 1.0)};
}

}  // namespace adit
