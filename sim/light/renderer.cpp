#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "parts.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;

/// Body frame (x forward, y left, z up) seen from the optical frame (x right, y down, z forward).
Eigen::Matrix3f body_of_optical() {
  Eigen::Matrix3f m;
  m << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return m;
}

/// The lens on the body: optical frame to body frame.
Eigen::Isometry3f mount_of(const LensConfig& lens) {
  Eigen::Isometry3f mount = Eigen::Isometry3f::Identity();
  mount.translate(Vector3f(lens.forward_m, lens.left_m, lens.up_m));
  // Pitch up turns x towards z: about -y.
  mount.rotate(Eigen::AngleAxisf(-lens.pitch_deg * kDegree, Vector3f::UnitY()));
  mount.rotate(body_of_optical());
  return mount;
}

std::vector<OwnLamp> own_lamps_of(const RigConfig& rig) {
  const Eigen::Isometry3f to_optical = mount_of(rig.lens).inverse();
  std::vector<OwnLamp> lamps;
  for (const Lamp& lamp : rig.lamps.lamps) {
    const float yaw = lamp.yaw_deg * kDegree, pitch = lamp.pitch_deg * kDegree;
    const Vector3f axis(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch));
    lamps.push_back({to_optical * Vector3f(lamp.forward_m, lamp.left_m, lamp.up_m),
                     to_optical.linear() * axis,
                     LampLobe(lamp),
                     intensity_on_axis_cd(lamp),
                     {}});
  }
  return lamps;
}

void fill_directions(Renderer::Parts& parts) {
  parts.directions.resize(static_cast<std::size_t>(3) * parts.stride * parts.rows);
  const int across = parts.stride / kTileWidth;
  for (int v = 0; v < parts.rows; ++v)
    for (int u = 0; u < parts.stride; ++u) {
      const NormalisedPoint n = parts.camera->normalised_of(
          {static_cast<double>(std::min(u, parts.width - 1)), static_cast<double>(std::min(v, parts.height - 1))});
      const double length = std::sqrt(n.sx * n.sx + n.sy * n.sy + 1.0);
      float* const d =
          &parts.directions[static_cast<std::size_t>(v / kTileHeight * across + u / kTileWidth) * 3 * kTileLanes +
                            v % kTileHeight * kTileWidth + u % kTileWidth];
      d[0] = static_cast<float>(n.sx / length);
      d[kTileLanes] = static_cast<float>(n.sy / length);
      d[2 * kTileLanes] = static_cast<float>(1.0 / length);
    }
  const int runs = parts.stride / kBlurRun_px;
  parts.run_directions.resize(static_cast<std::size_t>(3) * runs * parts.height);
  for (int v = 0; v < parts.height; ++v)
    for (int i = 0; i < runs; ++i) {
      const Vector3f ray = parts.ray_of(std::min(i * kBlurRun_px + kBlurRun_px / 2, parts.width - 1), v);
      for (int k = 0; k < 3; ++k) parts.run_directions[(static_cast<std::size_t>(v) * 3 + k) * runs + i] = ray[k];
    }
}

double ms_since(std::chrono::steady_clock::time_point& from) {
  const auto now = std::chrono::steady_clock::now();
  const double ms = std::chrono::duration<double, std::milli>(now - from).count();
  from = now;
  return ms;
}

CameraMotion motion_of(const Renderer::Parts& parts, const Eigen::Isometry3f& pose, const Shot& shot) {
  CameraMotion motion;
  motion.pose = pose;
  const Eigen::Matrix3f to_optical = mount_of(parts.rig.lens).linear().transpose();
  const Vector3f turn_world = shot.pose.attitude * shot.pose.angular_rate_rad_s;
  const Vector3f arm = pose.translation() - shot.pose.place;
  motion.velocity_m_s = pose.linear().transpose() * (shot.pose.velocity_m_s + turn_world.cross(arm));
  motion.turn_rate_rad_s = to_optical * shot.pose.angular_rate_rad_s;
  motion.white_luminance =
      parts.rig.sensor.full_well_e /
      (electrons_per_luminance_second(parts.rig.lens, parts.rig.sensor) * shot.exposure.time_s * shot.exposure.gain);
  return motion;
}

}  // namespace

MaterialTable material_table_of(const World& world) {
  MaterialTable table{};
  if (world.materials.empty() || world.materials.size() > kMaterialsMax)
    throw std::invalid_argument("the world has " + std::to_string(world.materials.size()) +
                                " materials; 1 to 256 are possible");
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    const Material& m = world.materials[i];
    table.albedo[i] = m.albedo;
    table.sigma[i] = m.albedo_log_sigma;
    table.patch_1_m[i] = 1.0f / std::max(m.patch_size_m, 1e-3f);
    table.specular[i] = m.specular;
    table.shininess[i] = m.shininess;
    table.emission[i] = m.emission_cd_m2;
    table.facet_slope[i] = m.facet_slope;
    table.facet_1_m[i] = 1.0f / std::max(m.facet_size_m, 1e-3f);
    table.red[i] = m.tint.x() / std::max(m.tint.y(), 1e-3f);
    table.blue[i] = m.tint.z() / std::max(m.tint.y(), 1e-3f);
  }
  for (const std::uint8_t m : world.mesh.materials)
    if (m >= world.materials.size())
      throw std::invalid_argument("the mesh names material " + std::to_string(m) + " of " +
                                  std::to_string(world.materials.size()));
  return table;
}

Renderer::Renderer(const World& world, const RigConfig& rig, const RenderConfig& render,
                   std::shared_ptr<const RayScene> scene)
    : parts_(std::make_unique<Parts>()) {
  if (const std::string fault = fault_of(rig); !fault.empty()) throw std::invalid_argument(fault);
  Parts& p = *parts_;
  p.world = &world;
  p.rig = rig;
  p.render = render;
  p.materials = material_table_of(world);
  p.scene = scene ? std::move(scene) : std::make_shared<const RayScene>(world.mesh);
  p.camera = std::make_unique<Camera>(camera_model(rig.lens));
  // No more than there are: TBB would say so on the terminal.
  const int most = tbb::info::default_concurrency();
  const int threads = render.threads > 0 ? std::min(render.threads, most) : most;
  if (threads > 1) p.arena = std::make_unique<tbb::task_arena>(threads);
  p.width = rig.lens.width;
  p.height = rig.lens.height;
  p.stride = (p.width + kTileWidth - 1) / kTileWidth * kTileWidth;
  p.rows = (p.height + kTileHeight - 1) / kTileHeight * kTileHeight;
  p.pixel_angle = static_cast<float>(1.0 / p.camera->model().focal_length_x_px);
  fill_directions(p);
  p.triangles = triangle_table_of(world);
  p.tree = mesh_tree_of(world.mesh);
  p.own_lamps = own_lamps_of(rig);
  for (OwnLamp& lamp : p.own_lamps) lamp.parallax = parallax_of(lamp.place, p);
  p.foreign_lamps = foreign_lamps_of(world, *p.scene);
  if (render.virtual_lights > 0)
    p.foreign_bounces = bounces_of_foreign(world, *p.scene, p.foreign_lamps, rig.dust.extinction_1_m);
  for (const Node& node : world.nodes)
    if (node.kind == NodeKind::kMouth) p.mouths.push_back(node.place);
  p.backscatter = backscatter_of(p.own_lamps, rig.dust, *p.camera, p.stride, p.rows);
  p.sensor = sensor_tables_of(p);
  p.dirt_passed = dirt_passed_of(p);
  const std::size_t count = static_cast<std::size_t>(p.stride) * p.rows;
  for (int c = 0; c < 3; ++c) {
    p.planes[c].resize(count);
    p.blurred[c].resize(count);
  }
  p.range.resize(count);
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const RayScene& Renderer::scene() const noexcept { return *parts_->scene; }
std::shared_ptr<const RayScene> Renderer::shared_scene() const noexcept { return parts_->scene; }
const Camera& Renderer::camera() const noexcept { return *parts_->camera; }
const RigConfig& Renderer::rig() const noexcept { return parts_->rig; }
void Renderer::both(const std::function<void()>& one, const std::function<void()>& other) const {
  parts_->each(2, [&](int i) { i == 0 ? one() : other(); });
}

Eigen::Isometry3f Renderer::camera_pose(const RigPose& pose) const {
  Eigen::Isometry3f body = Eigen::Isometry3f::Identity();
  body.translate(pose.place);
  body.rotate(pose.attitude.normalized());
  return body * mount_of(parts_->rig.lens);
}

void Renderer::render(const Shot& shot, Frame& frame) {
  Parts& p = *parts_;
  const CameraMotion motion = motion_of(p, camera_pose(shot.pose), shot);
  frame.width = p.width;
  frame.height = p.height;
  frame.exposure = shot.exposure;
  p.lamps_on = shot.lamps_on;
  auto clock = std::chrono::steady_clock::now();
  light_pass(p, motion, p.rig.sensor.readout_s);
  frame.times.light_ms = ms_since(clock);
  lens_pass(p, motion, shot);
  dirt_pass(p);
  frame.times.lens_ms = ms_since(clock);
  sensor_pass(p, shot, frame);
  frame.times.sensor_ms = ms_since(clock);
  jpeg_pass(p, frame);
  frame.times.jpeg_ms = ms_since(clock);
  frame.range_m.resize(static_cast<std::size_t>(p.width) * p.height);
  p.each(p.height, [&](int v) {
    std::copy_n(&p.range[static_cast<std::size_t>(v) * p.stride], p.width,
                &frame.range_m[static_cast<std::size_t>(v) * p.width]);
  });
}

Frame Renderer::render(const Shot& shot) {
  Frame frame;
  render(shot, frame);
  return frame;
}

Radiance Renderer::radiance(const Shot& shot) {
  Parts& p = *parts_;
  const CameraMotion motion = motion_of(p, camera_pose(shot.pose), shot);
  p.lamps_on = shot.lamps_on;
  light_pass(p, motion, p.rig.sensor.readout_s);
  lens_pass(p, motion, shot);
  dirt_pass(p);
  Radiance radiance{p.width, p.height, {}, {}, {}};
  std::vector<float>* const out[3] = {&radiance.red, &radiance.green, &radiance.blue};
  for (int c = 0; c < 3; ++c) {
    out[c]->resize(static_cast<std::size_t>(p.width) * p.height);
    for (int v = 0; v < p.height; ++v)
      std::copy_n(&p.planes[c][static_cast<std::size_t>(v) * p.stride], p.width,
                  &(*out[c])[static_cast<std::size_t>(v) * p.width]);
  }
  return radiance;
}

}  // namespace adit::sim
