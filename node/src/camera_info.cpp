#include "adit/node/camera_info.hpp"

#include <algorithm>

#include "text.hpp"

namespace adit::node {
namespace {

/// Empty when all is well.
std::string take_distortion(const CameraInfoMessage& m, CameraModel& model) {
  const bool all_zero = std::all_of(m.distortion.begin(), m.distortion.end(), [](double k) { return k == 0.0; });
  if (m.distortion_model.empty() && all_zero) return "";
  if (!parse(m.distortion_model, model.distortion_model))
    return "distortion_model: " + quoted(m.distortion_model) +
           " is not known; calibrate with plumb_bob, rational_polynomial or equidistant";
  const auto used = static_cast<std::size_t>(coefficient_count(model.distortion_model));
  for (std::size_t i = 0; i < m.distortion.size(); ++i) {
    if (i < used)
      model.distortion[i] = m.distortion[i];
    else if (m.distortion[i] != 0.0)
      return "D: " + std::to_string(m.distortion.size()) + " coefficients, but " + m.distortion_model + " has " +
             std::to_string(used) + "; calibrate again";
  }
  return "";
}

/// What happens to fx, ox and the width on the way from the sensor to the image; x and y alike.
void crop_and_bin(double& focal_length_px, double& principal_point_px, int& side, std::uint32_t offset,
                  std::uint32_t extent, std::uint32_t binning) {
  const std::uint32_t bin = std::max(binning, 1u);
  if (extent > 0) side = static_cast<int>(std::min<std::uint32_t>(extent, kSideMax_px));
  side /= static_cast<int>(std::min<std::uint32_t>(bin, kSideMax_px));
  focal_length_px /= bin;
  // Pixel centres are at integers: the middle of the first two pixels is at 0.5.
  principal_point_px = (principal_point_px - offset + 0.5) / bin - 0.5;
}

}  // namespace

CameraReading camera_of(const CameraInfoMessage& m) {
  if (m.matrix[0] == 0.0) return {};
  CameraModel model;
  model.width = static_cast<int>(std::min<std::uint32_t>(m.width, 1u << 20));
  model.height = static_cast<int>(std::min<std::uint32_t>(m.height, 1u << 20));
  model.focal_length_x_px = m.matrix[0];
  model.focal_length_y_px = m.matrix[4];
  model.principal_point_x_px = m.matrix[2];
  model.principal_point_y_px = m.matrix[5];
  if (std::string fault = take_distortion(m, model); !fault.empty()) return {std::nullopt, std::move(fault)};
  crop_and_bin(model.focal_length_x_px, model.principal_point_x_px, model.width, m.roi_x_offset, m.roi_width,
               m.binning_x);
  crop_and_bin(model.focal_length_y_px, model.principal_point_y_px, model.height, m.roi_y_offset, m.roi_height,
               m.binning_y);
  if (auto fault = fault_of(model)) return {std::nullopt, *fault};
  return {model, ""};
}

}  // namespace adit::node
