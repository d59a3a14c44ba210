// The camera: from pixels to directions and back (paper, eq. 10, with the lens's distortion undone).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "adit/api.hpp"

namespace ADIT_API adit {

/// A place in the image. Pixel centres are at integers, the origin is the centre of the top left pixel.
struct Pixel {
  double u_px = 0.0;  ///< to the right
  double v_px = 0.0;  ///< down
};

/// Eq. (10): a point on the plane z = 1 of the optical frame (x right, y down, z forward), unitless.
struct NormalisedPoint {
  double sx = 0.0;  ///< to the right
  double sy = 0.0;  ///< down
};

/// A direction from the camera.
struct Bearing {
  double azimuth_rad = 0.0;    ///< positive to the right of the optical axis, (-pi, pi]
  double elevation_rad = 0.0;  ///< positive above the optical axis, [-pi/2, pi/2]
};

/// Distortion models, named as in ROS's sensor_msgs/CameraInfo.
enum class DistortionModel { kNone, kPlumbBob, kRationalPolynomial, kEquidistant };
/// "none", "plumb_bob", "rational_polynomial", "equidistant".
[[nodiscard]] std::string_view to_string(DistortionModel model) noexcept;
/// The other way round; false and no change when the name is unknown.
[[nodiscard]] bool parse(std::string_view name, DistortionModel& model) noexcept;
/// Coefficients of the model that count: 0, 5, 8, 4.
[[nodiscard]] int coefficient_count(DistortionModel model) noexcept;

/// The figures of a calibration, as in a ROS camera_info file. The models are OpenCV's (cv::projectPoints and
/// cv::fisheye::projectPoints). Ranges are those that fault_of() checks; a calibration outside them is a mistake.
struct CameraModel {
  int width = 0;                      ///< px, of the frames the calibration was made with; 16 to 8192
  int height = 0;                     ///< px; 16 to 8192
  double focal_length_x_px = 0.0;     ///< fx, 1 to 1e6
  double focal_length_y_px = 0.0;     ///< fy, 1 to 1e6
  double principal_point_x_px = 0.0;  ///< ox, at most the width outside the frame
  double principal_point_y_px = 0.0;  ///< oy, at most the height outside the frame
  DistortionModel distortion_model = DistortionModel::kNone;
  /// k1 k2 p1 p2 k3 (plumb_bob), k1 k2 p1 p2 k3 k4 k5 k6 (rational_polynomial), k1 k2 k3 k4 (equidistant).
  /// Each -1e6 to 1e6. Those the model does not use are not looked at.
  std::array<double, 8> distortion{};
};

/// An ideal pinhole with square pixels and the principal point in the middle, ((width - 1)/2, (height - 1)/2).
/// @param hfov_deg  horizontal field of view from the left edge of the first pixel to the right edge of the last,
///                  10 to 170 deg.
/// @throws std::invalid_argument naming the argument, the value and the range.
[[nodiscard]] CameraModel pinhole(int width, int height, double hfov_deg);

/// The same camera after its frames were resized to width x height (pixel centres at integers).
[[nodiscard]] CameraModel resized(const CameraModel& model, int width, int height);

/// Why a model is not a camera, naming the field, the value and the range; empty when it is one.
[[nodiscard]] std::optional<std::string> fault_of(const CameraModel& model);

/// A checked CameraModel that turns pixels into directions and back.
class Camera {
 public:
  /// @throws std::invalid_argument with the text of fault_of(model).
  explicit Camera(const CameraModel& model);

  [[nodiscard]] const CameraModel& model() const noexcept { return model_; }

  /// Eq. (10) with the distortion undone (safeguarded Newton iteration; exact to 1e-9 inside the lens's circle).
  /// The lens's circle is where the model's radius still grows with the angle, at most 89 deg off the axis. A pixel
  /// outside it gives the nearest point on the circle: for a finite pixel the answer is always finite.
  [[nodiscard]] NormalisedPoint normalised_of(Pixel pixel) const noexcept;
  /// The pixel where a point of the plane z = 1 is seen. May lie outside the frame.
  [[nodiscard]] Pixel pixel_of(NormalisedPoint point) const noexcept;

  /// Unlike normalised_of, goes past 90 deg off the axis for an equidistant lens that sees that far.
  [[nodiscard]] Bearing bearing_of(Pixel pixel) const noexcept;
  /// Empty for directions at or behind the image plane (|azimuth| >= 90 deg).
  [[nodiscard]] std::optional<Pixel> pixel_of(Bearing bearing) const noexcept;

 private:
  CameraModel model_;
  double radius_max_ = 0.0;  ///< of the lens's circle: on the plane z = 1, or in radians for kEquidistant
};

[[nodiscard]] Bearing bearing_of(NormalisedPoint point) noexcept;
[[nodiscard]] std::optional<NormalisedPoint> normalised_of(Bearing bearing) noexcept;

}  // namespace adit
