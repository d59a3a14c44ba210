// The camera: from pixels to directions and back (paper, eq. 10, with the lens's distortion undone).
#pragma once

#include <array>
#include <optional>
#include <string>

namespace adit {

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

/// The figures of a calibration, as in a ROS camera_info file.
struct CameraModel {
  int width = 0;                      ///< px, of the frames the calibration was made with
  int height = 0;                     ///< px
  double focal_length_x_px = 0.0;     ///< fx > 0
  double focal_length_y_px = 0.0;     ///< fy > 0
  double principal_point_x_px = 0.0;  ///< ox
  double principal_point_y_px = 0.0;  ///< oy
  DistortionModel distortion_model = DistortionModel::kNone;
  /// k1 k2 p1 p2 k3 (plumb_bob), k1 k2 p1 p2 k3 k4 k5 k6 (rational_polynomial), k1 k2 k3 k4 (equidistant).
  std::array<double, 8> distortion{};
};

/// An ideal pinhole with square pixels and the principal point in the middle, ((width - 1)/2, (height - 1)/2).
/// @param hfov_deg horizontal field of view, 10 to 170 deg.
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

  /// Eq. (10) with the distortion undone (Newton iteration on the model; exact to 1e-9 inside the lens's circle).
  [[nodiscard]] NormalisedPoint normalised_of(Pixel pixel) const noexcept;
  /// The pixel where a point of the plane z = 1 is seen. May lie outside the frame.
  [[nodiscard]] Pixel pixel_of(NormalisedPoint point) const noexcept;

  [[nodiscard]] Bearing bearing_of(Pixel pixel) const noexcept;
  /// Empty for directions at or behind the image plane (|azimuth| >= 90 deg).
  [[nodiscard]] std::optional<Pixel> pixel_of(Bearing bearing) const noexcept;

 private:
  CameraModel model_;
};

[[nodiscard]] Bearing bearing_of(NormalisedPoint point) noexcept;
[[nodiscard]] std::optional<NormalisedPoint> normalised_of(Bearing bearing) noexcept;

}  // namespace adit
