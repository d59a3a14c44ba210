#include "adit/node/simulated_robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adit/sim/course.hpp"
#include "adit/sim/flight.hpp"
#include "adit/sim/lidar.hpp"
#include "adit/sim/network.hpp"
#include "adit/sim/rendered_eye.hpp"
#include "adit/sim/world_error.hpp"

namespace adit::node {
namespace {

constexpr double kPhysicsRate_hz = 200.0;
constexpr double kGoalReach_m = 1.0;
constexpr float kLookForRock_m = 30.0f;
// As Flight's: frames of one flight share no noise.
constexpr std::uint64_t kFrameSeedStep = 0x9e3779b97f4a7c15ull;

std::array<double, 3> array_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Placement placement(const Eigen::Vector3d& place, const Eigen::Quaterniond& q) {
  return {array_of(place), {q.x(), q.y(), q.z(), q.w()}};
}

sim::RigConfig rig_of(const SimulatedRobotConfig& config) {
  sim::RigConfig rig = sim::rig_preset(config.lamp);
  rig.lens.width = config.width;
  rig.lens.height = config.height;
  rig.dust.extinction_1_m = static_cast<float>(config.dust_1_m);
  return rig;
}

sim::RenderConfig render_of(const SimulatedRobotConfig& config) {
  sim::RenderConfig render;
  render.threads = config.threads;
  return render;
}

}  // namespace

struct SimulatedRobot::Parts {
  explicit Parts(const SimulatedRobotConfig& config)
      : world(sim::build_course(sim::read_course(config.course_file))),
        scene(std::make_shared<const sim::RayScene>(world.mesh)),
        eye(world, rig_of(config), render_of(config), scene),
        network(world),
        vehicle({}, *scene, world.start, config.seed),
        lidar({}, *scene, config.seed),
        imu({}, config.seed) {}

  sim::World world;
  std::shared_ptr<const sim::RayScene> scene;
  sim::RenderedEye eye;
  sim::Network network;
  sim::Vehicle vehicle;
  sim::Lidar lidar;
  sim::Imu imu;
};

SimulatedRobot::SimulatedRobot(const SimulatedRobotConfig& config) : config_(config) {
  if (!(config.camera_rate_hz >= 1.0 && config.camera_rate_hz <= 120.0))
    throw std::invalid_argument("camera_rate_hz: it is not in [1, 120] Hz; set a value in this range");
  try {
    parts_ = std::make_unique<Parts>(config);
  } catch (const sim::WorldError& e) {
    throw std::invalid_argument(e.what());
  }
}

SimulatedRobot::~SimulatedRobot() = default;

const Camera& SimulatedRobot::camera() const noexcept { return parts_->eye.camera(); }

Placement SimulatedRobot::camera_in_body() const {
  const sim::CameraPose pose = parts_->eye.pose(sim::VehicleState());  // of a body at the world's origin, level
  return placement(pose.translation(), Eigen::Quaterniond(pose.rotation()));
}

RobotMotion SimulatedRobot::motion() const {
  const sim::VehicleState& v = parts_->vehicle.state();
  return {placement(v.place, v.attitude()), array_of(v.attitude().conjugate() * v.velocity),
          array_of(v.angular_rate())};
}

ImageView SimulatedRobot::look() {
  return parts_->eye.look(parts_->vehicle.state(), time_s_,
                          config_.seed * kFrameSeedStep + static_cast<std::uint64_t>(frames_));
}

bool SimulatedRobot::fly(double forward_m_s, double yaw_rate_rad_s) {
  if (!outcome_.empty()) return false;
  imu_.clear();
  const sim::VehicleState& vehicle = parts_->vehicle.state();
  sweep();
  const double interval_s = 1.0 / config_.camera_rate_hz;
  const auto steps = static_cast<int>(std::ceil(kPhysicsRate_hz * interval_s));
  const double step_s = interval_s / steps;
  for (int i = 1; i <= steps && outcome_.empty(); ++i) {
    const Eigen::Vector3d before = vehicle.place;
    if (parts_->vehicle.step({forward_m_s, yaw_rate_rad_s}, step_s)) outcome_ = to_string(sim::Outcome::kCollided);
    distance_m_ += (vehicle.place - before).norm();
    const auto sample =
        parts_->imu.sample(vehicle.angular_rate(), parts_->vehicle.specific_force(), time_s_ + i * step_s, step_s);
    imu_.push_back({sample.stamp_s, array_of(sample.angular_rate_rad_s), array_of(sample.specific_force_m_s2)});
  }
  time_s_ = static_cast<double>(++frames_) / config_.camera_rate_hz;
  judge();
  return outcome_.empty();
}

void SimulatedRobot::sweep() {
  scan_.reset();
  const double next_s = static_cast<double>(frames_ + 1) / config_.camera_rate_hz;
  const sim::LidarConfig& lidar = parts_->lidar.config();
  if (frames_ > 0 && std::floor(next_s * lidar.lidar_rate_hz) <= std::floor(time_s_ * lidar.lidar_rate_hz)) return;
  const sim::VehicleState& v = parts_->vehicle.state();
  sim::Scan scan = parts_->lidar.sweep(v.place, v.attitude(), time_s_);
  scan_ = ScanReading{scan.stamp_s,
                      scan.angle_min_rad,
                      scan.angle_step_rad,
                      1.0 / lidar.lidar_rate_hz,
                      lidar.lidar_range_min_m,
                      lidar.lidar_range_max_m,
                      std::move(scan.ranges_m)};
}

void SimulatedRobot::judge() {
  const Eigen::Vector3d& place = parts_->vehicle.state().place;
  const auto rock = parts_->scene->nearest(place.cast<float>(), kLookForRock_m);
  if (rock) clearance_min_m_ = std::min(clearance_min_m_, static_cast<double>(rock->distance_m));
  if (!outcome_.empty()) return;
  if (!parts_->network.empty() && parts_->network.to_goal_m(parts_->network.nearest(place)) <= kGoalReach_m)
    outcome_ = to_string(sim::Outcome::kGoal);
  else if (time_s_ >= config_.time_max_s)
    outcome_ = to_string(sim::Outcome::kTimeout);
}

}  // namespace adit::node
