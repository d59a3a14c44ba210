// Fields that messages of ROS share, filled by name: no message is included here, so that bags and nodes use the same.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "adit/camera.hpp"

namespace adit::node {

/// @param m  x, y, z: geometry_msgs' Vector3 or Point.
template <class Message>
void fill_vector(Message& m, const std::array<double, 3>& v) {
  m.x = v[0];
  m.y = v[1];
  m.z = v[2];
}

/// @param q  x, y, z, w.
template <class Message>
void fill_quaternion(Message& m, const std::array<double, 4>& q) {
  m.x = q[0];
  m.y = q[1];
  m.z = q[2];
  m.w = q[3];
}

/// sensor_msgs/CameraInfo of ROS 1, all but the header. A lens without distortion is a plumb_bob of zeros.
template <class CameraInfo>
void fill_camera_info(CameraInfo& info, const CameraModel& model) {
  info.width = static_cast<decltype(info.width)>(model.width);
  info.height = static_cast<decltype(info.height)>(model.height);
  const bool is_ideal = model.distortion_model == DistortionModel::kNone;
  const DistortionModel named = is_ideal ? DistortionModel::kPlumbBob : model.distortion_model;
  info.distortion_model = std::string(to_string(named));
  info.D.assign(model.distortion.begin(), model.distortion.begin() + coefficient_count(named));
  if (is_ideal) std::fill(info.D.begin(), info.D.end(), 0.0);
  const double fx = model.focal_length_x_px, fy = model.focal_length_y_px;
  const double ox = model.principal_point_x_px, oy = model.principal_point_y_px;
  info.K = {fx, 0, ox, 0, fy, oy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {fx, 0, ox, 0, 0, fy, oy, 0, 0, 0, 1, 0};
}

}  // namespace adit::node
