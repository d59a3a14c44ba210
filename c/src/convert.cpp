#include "convert.hpp"

#include <cmath>

#include "sized_struct.hpp"

namespace adit::c_interface {

// The numbers of the enumerations are promised to callers; the core's may not move away from them unseen.
static_assert(static_cast<int>(Status::kFound) == ADIT_FOUND && static_cast<int>(Status::kTooDark) == ADIT_TOO_DARK &&
              static_cast<int>(Status::kTooBright) == ADIT_TOO_BRIGHT &&
              static_cast<int>(Status::kNoContrast) == ADIT_NO_CONTRAST &&
              static_cast<int>(Status::kNoRegion) == ADIT_NO_REGION &&
              static_cast<int>(Status::kBadFrame) == ADIT_BAD_FRAME &&
              static_cast<int>(Status::kWrongSize) == ADIT_WRONG_SIZE &&
              static_cast<int>(Status::kNoOpening) == ADIT_NO_OPENING &&
              static_cast<int>(Status::kBlockedLens) == ADIT_BLOCKED_LENS &&
              static_cast<int>(Status::kDust) == ADIT_DUST &&
              static_cast<int>(Status::kFrozenFrame) == ADIT_FROZEN_FRAME &&
              static_cast<int>(Status::kTornFrame) == ADIT_TORN_FRAME && kStatusCount == ADIT_TORN_FRAME + 1);
static_assert(static_cast<int>(PixelFormat::kGrey8) == ADIT_GREY8 &&
              static_cast<int>(PixelFormat::kBgr8) == ADIT_BGR8 && static_cast<int>(PixelFormat::kRgb8) == ADIT_RGB8 &&
              static_cast<int>(PixelFormat::kBgra8) == ADIT_BGRA8 &&
              static_cast<int>(PixelFormat::kRgba8) == ADIT_RGBA8 &&
              static_cast<int>(PixelFormat::kGrey16) == ADIT_GREY16);
static_assert(static_cast<int>(HeadingState::kSteer) == ADIT_STEER &&
              static_cast<int>(HeadingState::kCoast) == ADIT_COAST &&
              static_cast<int>(HeadingState::kHold) == ADIT_HOLD);
static_assert(static_cast<int>(Manoeuvre::kWait) == ADIT_WAIT && static_cast<int>(Manoeuvre::kFollow) == ADIT_FOLLOW &&
              static_cast<int>(Manoeuvre::kTurn) == ADIT_TURN && static_cast<int>(Manoeuvre::kGiveUp) == ADIT_GIVE_UP);
static_assert(static_cast<int>(DistortionModel::kNone) == ADIT_NO_DISTORTION &&
              static_cast<int>(DistortionModel::kPlumbBob) == ADIT_PLUMB_BOB &&
              static_cast<int>(DistortionModel::kRationalPolynomial) == ADIT_RATIONAL_POLYNOMIAL &&
              static_cast<int>(DistortionModel::kEquidistant) == ADIT_EQUIDISTANT);

ImageView view_of(const adit_image* image) {
  const adit_image given = read_sized(image, "image");
  // A format out of range stays one: the core answers bad_frame.
  const int format = given.format >= 0 && given.format <= 255 ? given.format : 255;
  const auto stride = [](std::ptrdiff_t bytes) { return bytes == 0 ? kSideBySide : bytes; };
  return {given.data,
          given.width,
          given.height,
          given.stride_bytes,
          static_cast<PixelFormat>(format),
          stride(given.pixel_stride_bytes),
          stride(given.channel_stride_bytes)};
}

std::optional<Camera> camera_of(const adit_camera* camera) {
  if (camera == nullptr) return std::nullopt;
  const adit_camera given = read_sized(camera, "camera");
  if (given.distortion_model < ADIT_NO_DISTORTION || given.distortion_model > ADIT_EQUIDISTANT)
    throw std::invalid_argument("camera.distortion_model: " + std::to_string(given.distortion_model) +
                                " is no adit_distortion");
  CameraModel model;
  model.width = given.width;
  model.height = given.height;
  model.focal_length_x_px = given.focal_length_x_px;
  model.focal_length_y_px = given.focal_length_y_px;
  model.principal_point_x_px = given.principal_point_x_px;
  model.principal_point_y_px = given.principal_point_y_px;
  model.distortion_model = static_cast<DistortionModel>(given.distortion_model);
  std::copy(std::begin(given.distortion), std::end(given.distortion), model.distortion.begin());
  return Camera(model);
}

Motion motion_of(const adit_motion* motion) {
  Motion known;
  if (motion == nullptr) return known;
  const adit_motion given = read_sized(motion, "motion");
  if (!std::isnan(given.yaw_rate_rad_s)) known.yaw_rate_rad_s = given.yaw_rate_rad_s;
  if (!std::isnan(given.speed_m_s)) known.speed_m_s = given.speed_m_s;
  return known;
}

adit_open_space c_of(const OpenSpace& open_space) noexcept {
  adit_open_space c{};
  c.status = static_cast<std::int32_t>(open_space.status);
  c.opening_count = open_space.opening_count;
  c.flags = (open_space.flags.dust ? ADIT_FLAG_DUST : 0u) | (open_space.flags.glare ? ADIT_FLAG_GLARE : 0u) |
            (open_space.flags.blocked_lens ? ADIT_FLAG_BLOCKED_LENS : 0u) |
            (open_space.flags.too_dark ? ADIT_FLAG_TOO_DARK : 0u) |
            (open_space.flags.too_bright ? ADIT_FLAG_TOO_BRIGHT : 0u) |
            (open_space.flags.dirty_lens ? ADIT_FLAG_DIRTY_LENS : 0u);
  c.darkest_level = open_space.darkest_level;
  c.atmospheric_light = open_space.atmospheric_light;
  c.veil_fraction = open_space.veil_fraction;
  c.total_ns = open_space.total_ns;
  if (!open_space.found()) return c;
  c.confidence = open_space.confidence;
  c.u_px = open_space.centroid_px.u_px;
  c.v_px = open_space.centroid_px.v_px;
  c.sx = open_space.point.sx;
  c.sy = open_space.point.sy;
  c.azimuth_rad = open_space.bearing.azimuth_rad;
  c.elevation_rad = open_space.bearing.elevation_rad;
  c.area_fraction = open_space.area_fraction;
  return c;
}

adit_opening c_of(const Opening& opening) noexcept {
  adit_opening c{};
  c.touches_border = opening.touches_border ? 1 : 0;
  c.u_px = opening.centroid_px.u_px;
  c.v_px = opening.centroid_px.v_px;
  c.sx = opening.point.sx;
  c.sy = opening.point.sy;
  c.azimuth_rad = opening.bearing.azimuth_rad;
  c.elevation_rad = opening.bearing.elevation_rad;
  c.area_fraction = opening.area_fraction;
  c.confidence = opening.confidence;
  c.half_width_rad = opening.half_width_rad;
  c.half_height_rad = opening.half_height_rad;
  c.score = opening.score;
  c.contrast = opening.contrast;
  c.left_px = opening.top_left_px.u_px;
  c.top_px = opening.top_left_px.v_px;
  c.right_px = opening.bottom_right_px.u_px;
  c.bottom_px = opening.bottom_right_px.v_px;
  return c;
}

adit_command c_of(const NavigatorCommand& command) noexcept {
  adit_command c{};
  c.heading_state = static_cast<std::int32_t>(command.heading.state);
  c.manoeuvre = static_cast<std::int32_t>(command.manoeuvre);
  c.status = static_cast<std::int32_t>(command.status);
  c.stamp_fault = static_cast<std::int32_t>(command.stamp_fault);
  c.yaw_rate_rad_s = command.heading.yaw_rate_rad_s;
  c.speed_scale = command.speed_scale;
  c.target_rad = command.target_rad;
  c.free_m = command.free_m;
  return c;
}

}  // namespace adit::c_interface
