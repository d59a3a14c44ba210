// Calibrations, as ROS's camera_calibration writes them.
#pragma once

#include <filesystem>
#include <string_view>

#include "adit/camera.hpp"

namespace adit::io {

/// Reads the YAML of a ROS camera_info file: image_width, image_height, camera_matrix, distortion_model (plumb_bob,
/// rational_polynomial, equidistant or none) and distortion_coefficients. What else is in it is not looked at:
/// rectification and projection belong to stereo pairs.
/// @param name  the file's name, for messages.
/// @throws ConfigError "NAME:LINE: ..." for broken YAML, a missing or wrong field, or figures that are no camera.
[[nodiscard]] CameraModel camera_of_yaml(std::string_view text, std::string_view name);

/// The same for a file. @throws ConfigError also when the file is missing, empty or unreadable.
[[nodiscard]] CameraModel read_camera(const std::filesystem::path& path);

}  // namespace adit::io
