#include "adit/sim/flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "adit/sim/flight_fields.hpp"
#include "field_check.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3d;

constexpr double kGoalReach_m = 1.0;     // along the route
constexpr double kOutside_m = 3.0;       // beyond a mouth, and past the walls
constexpr double kStartMargin_m = 0.15;  // of a drawn start to the rock
constexpr std::uint64_t kFrameSeedStep = 0x9e3779b97f4a7c15ull;

std::string place_text(const Vector3d& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", p.x(), p.y(), p.z());
  return text;
}

/// The start, moved to the side and turned as the seed has it, but not into the rock.
StartPose drawn_start(const FlightSettings& settings, const StartPose& start, const RayScene& scene) {
  Random random(settings.seed, 4);
  const double aside_m = settings.flight.start_jitter_m * (2.0 * random.uniform() - 1.0);
  const double turn_deg = settings.flight.start_yaw_jitter_deg * (2.0 * random.uniform() - 1.0);
  const double yaw_rad = static_cast<double>(start.yaw_rad);
  const Vector3d left(-std::sin(yaw_rad), std::cos(yaw_rad), 0.0);
  for (const double share : {1.0, 0.5, 0.25}) {
    StartPose drawn = start;
    drawn.place += (share * aside_m * left).cast<float>();
    drawn.yaw_rad += static_cast<float>(turn_deg * std::numbers::pi / 180.0);
    const Eigen::Vector3f centre =
        drawn.place + static_cast<float>(settings.vehicle.height_m) * Eigen::Vector3f::UnitZ();
    if (!scene.nearest(centre, static_cast<float>(settings.vehicle.body_radius_m + kStartMargin_m))) return drawn;
  }
  return start;
}

bool is_published(const FlightSettings& settings) {
  const Pilot pilot = settings.flight.pilot;
  return pilot == Pilot::kPublished || (pilot == Pilot::kByMethod && settings.finder.method == Method::kPaper);
}

const FlightSettings& checked(const FlightSettings& settings) {
  if (const auto fault = fault_of(settings.flight)) throw std::invalid_argument(*fault);
  return settings;
}

}  // namespace

std::optional<std::string> fault_of(const FlightConfig& config) { return first_fault(config); }

std::string_view to_string(Outcome outcome) noexcept {
  constexpr std::string_view kNames[] = {"goal", "collided", "stopped", "stuck", "returned", "timeout"};
  return kNames[static_cast<std::size_t>(outcome)];
}

constexpr std::string_view kPilotNames[] = {"by_method", "published", "navigator"};

std::string_view to_string(Pilot pilot) noexcept { return kPilotNames[static_cast<std::size_t>(pilot)]; }

bool parse(std::string_view name, Pilot& pilot) noexcept {
  for (const Pilot p : {Pilot::kByMethod, Pilot::kPublished, Pilot::kNavigator}) {
    if (name != to_string(p)) continue;
    pilot = p;
    return true;
  }
  return false;
}

std::string_view to_string(Delivery delivery) noexcept {
  constexpr std::string_view kNames[] = {"fresh", "dropped", "repeated"};
  return kNames[static_cast<std::size_t>(delivery)];
}

Flight::Flight(const FlightSettings& settings, const World& world, const RayScene& scene, Eye& eye)
    : settings_(checked(settings)),
      eye_(&eye),
      network_(world),
      vehicle_(settings.vehicle, scene, drawn_start(settings, world.start, scene), settings.seed),
      surveyor_(settings.truth, scene, network_,
                2.0 * std::atan(0.5 * eye.camera().model().width / eye.camera().model().focal_length_x_px) * 180.0 /
                    std::numbers::pi),
      lidar_(settings.lidar, scene, settings.seed),
      imu_(settings.imu, settings.seed),
      map_(settings.flight.map_cell_m),
      delivery_random_(settings.seed, 5),
      physics_steps_(static_cast<int>(std::ceil(settings.flight.physics_rate_hz / settings.flight.camera_rate_hz))) {
  physics_step_s_ = 1.0 / (settings_.flight.camera_rate_hz * physics_steps_);
  if (!network_.empty()) start_ = network_.nearest(vehicle_.state().place);
  engage(settings);
}

Flight::~Flight() = default;

/// All is made before anything is replaced.
void Flight::engage(const FlightSettings& s) {
  if (is_published(s)) {
    OpenSpaceFinder finder(s.finder, eye_->camera());
    const HeadingController controller(s.heading);
    finder_.emplace(std::move(finder));
    controller_.emplace(controller);
    navigator_.reset();
    speed_scale_ = 1.0;
  } else {
    Navigator navigator(
        {s.finder, s.heading, s.column_range, s.range_memory, s.tracker, s.steering, s.frame_watch, s.lens_watch},
        eye_->camera());
    navigator_.emplace(std::move(navigator));
    speed_scale_ = 0.0;  // until it has said
    finder_.reset();
    controller_.reset();
  }
}

void Flight::change(const NavigatorConfig& config) {
  FlightSettings changed = settings_;
  changed.finder = config.finder;
  changed.heading = config.heading;
  changed.column_range = config.column_range;
  changed.range_memory = config.range_memory;
  changed.tracker = config.tracker;
  changed.steering = config.steering;
  changed.frame_watch = config.frame_watch;
  changed.lens_watch = config.lens_watch;
  engage(changed);
  settings_ = changed;
}

bool Flight::step() {
  if (outcome_) return false;
  row_ = FlightRow{};
  row_.frame = frames_;
  row_.stamp_s = time_s_;
  row_.vehicle = vehicle_.state();
  take_frame();
  deliver();
  row_.command = command_;
  row_.speed_scale = speed_scale_;
  if (navigator_) {
    row_.manoeuvre = manoeuvre_;
    if (const Track* track = navigator_->tracker().chosen()) row_.track = *track;
  }
  if (fly_to_next_frame()) judge_progress();
  ++frames_;
  return true;
}

/// Truth and the laser's sweep at the moment of the frame. They touch nothing that perception does.
void Flight::measure() {
  survey();
  sweep();
}

void Flight::survey() {
  const VehicleState& v = vehicle_.state();
  const Vector3d heading(std::cos(v.yaw_rad), std::sin(v.yaw_rad), 0.0);
  row_.truth = surveyor_.look(v.place, heading, eye_->pose(v), settings_.vehicle.height_m, start_);
}

void Flight::sweep() {
  scan_.reset();
  const double sweeps = settings_.lidar.lidar_rate_hz;
  const double next_s = time_s_ + physics_step_s_ * physics_steps_;
  if (frames_ > 0 && !(std::floor(next_s * sweeps) > std::floor(time_s_ * sweeps))) return;
  scan_ = lidar_.sweep(vehicle_.state().place, vehicle_.state().attitude(), time_s_);
  map_.add(*scan_, vehicle_.state().place, vehicle_.state().attitude());
}

/// The camera's side: a frame is taken and judged; what came of it is on its way to the pilot.
void Flight::take_frame() {
  // Both numbers are drawn for every frame, so that one fraction does not shift the frames of the other.
  const bool drops = delivery_random_.uniform() < settings_.flight.drop_fraction;
  const bool repeats = delivery_random_.uniform() < settings_.flight.repeat_fraction;
  row_.delivery = frames_ == 0 ? Delivery::kFresh
                  : drops      ? Delivery::kDropped
                  : repeats    ? Delivery::kRepeated
                               : Delivery::kFresh;
  if (row_.delivery == Delivery::kDropped) {
    measure();
    on_the_way_.push_back({time_s_, true, {}, {}});
    return;
  }
  if (row_.delivery == Delivery::kFresh) {
    is_lit_ = !eye_->flashes() || frames_ % 2 == 0;
    eye_->switch_lamps(is_lit_);
    frame_ =
        eye_->look(vehicle_.state(), time_s_, settings_.seed * kFrameSeedStep + static_cast<std::uint64_t>(frames_));
  }
  row_.lamps_on = is_lit_;
  const Sight sight = judged_and_measured();
  open_space_ = sight.open_space;
  row_.status = open_space_.status;
  row_.confidence = open_space_.confidence;
  row_.centroid_px = open_space_.centroid_px;
  row_.point = open_space_.point;
  row_.bearing = open_space_.bearing;
  row_.area_fraction = open_space_.area_fraction;
  row_.flags = open_space_.flags;
  on_the_way_.push_back({time_s_, false, sight, {vehicle_.state().yaw_rate_rad_s, speed_m_s()}});
}

Sight Flight::judged_and_measured() {
  Sight sight;
  eye_->both([&] { sight = judged(); }, [&] { measure(); });
  return sight;
}

/// What perception makes of the frame; of an eye that flashes, of it and the last one with the lamps the other way.
Sight Flight::judged() {
  Sight sight;
  if (eye_->flashes()) {
    const auto rows = static_cast<std::size_t>(frame_.height);
    kept_[is_lit_ ? 1 : 0].assign(frame_.data, frame_.data + rows * static_cast<std::size_t>(frame_.stride_bytes));
    const std::vector<std::uint8_t>& other = kept_[is_lit_ ? 0 : 1];
    if (!other.empty()) {
      ImageView before = frame_;
      before.data = other.data();
      if (navigator_) return navigator_->look_flash(frame_, before);
      sight.open_space = finder_->find_flash(frame_, before);
      return sight;
    }
  }
  if (navigator_) return navigator_->look(frame_);
  sight.open_space = finder_->find(frame_);
  return sight;
}

/// The pilot's side: what was taken camera_delay_frames ago arrives, or is missed.
void Flight::deliver() {
  if (static_cast<int>(on_the_way_.size()) <= settings_.flight.camera_delay_frames) return;
  const Arrival& arrival = on_the_way_.front();
  if (navigator_) {
    const NavigatorCommand command = arrival.dropped
                                         ? navigator_->tick(arrival.stamp_s)
                                         : navigator_->steer(arrival.sight, arrival.stamp_s, arrival.motion);
    command_ = command.heading;
    speed_scale_ = command.speed_scale;
    manoeuvre_ = command.manoeuvre;
  } else {
    command_ = arrival.dropped ? controller_->tick(arrival.stamp_s)
                               : controller_->update(arrival.sight.open_space, arrival.stamp_s);
  }
  on_the_way_.pop_front();
}

/// Forward, as commanded.
double Flight::speed_m_s() const noexcept {
  return command_.state == HeadingState::kHold ? 0.0 : speed_scale_ * settings_.flight.speed_m_s;
}

bool Flight::fly_to_next_frame() {
  imu_samples_.clear();
  const VehicleCommand command{speed_m_s(), command_.yaw_rate_rad_s};
  const double start_s = time_s_;
  for (int i = 1; i <= physics_steps_; ++i) {
    const Vector3d before = vehicle_.state().place;
    const auto contact = vehicle_.step(command, physics_step_s_);
    time_s_ = start_s + i * physics_step_s_;
    distance_m_ += (vehicle_.state().place - before).norm();
    if (records_sensors_)
      imu_samples_.push_back(
          imu_.sample(vehicle_.state().angular_rate(), vehicle_.specific_force(), time_s_, physics_step_s_));
    if (!contact) continue;
    Truth at_rest;
    surveyor_.measure_clearance(vehicle_.state().place, at_rest);
    touched_side_m_ = at_rest.side_clearance_m;
    end(Outcome::kCollided, "touched rock at " + place_text(contact->place.cast<double>()));
    return false;
  }
  // Counted from zero, so that a long flight's clock does not drift from its frames.
  time_s_ = static_cast<double>(frames_ + 1) / settings_.flight.camera_rate_hz;
  return true;
}

bool Flight::is_stuck() {
  const Vector3d& place = vehicle_.state().place;
  track_.emplace_back(distance_m_, place);
  while (track_.size() > 1 && track_[1].first <= distance_m_ - settings_.flight.stuck_after_m) track_.pop_front();
  // All of the way, not its ends alone: who comes back out of a dead end is not stuck.
  return track_.front().first <= distance_m_ - settings_.flight.stuck_after_m &&
         std::all_of(track_.begin(), track_.end(), [&](const auto& passed) {
           return (passed.second - place).norm() < 2.0 * settings_.flight.stuck_radius_m;
         });
}

void Flight::judge_progress() {
  const Vector3d& place = vehicle_.state().place;
  if (command_.state != HeadingState::kHold) held_since_s_ = time_s_;
  if (start_) {
    const AxisPlace here = network_.nearest(place);
    if (network_.to_goal_m(here) <= kGoalReach_m)
      return end(Outcome::kGoal, "reached the goal at " + place_text(place));
    const bool at_mouth = network_.is_mouth(here);
    has_been_inside_ = has_been_inside_ || !at_mouth;
    if (at_mouth && has_been_inside_ && here.aside_m > kOutside_m + 0.5 * here.width_m)
      return end(Outcome::kReturned, "left through the mouth at " + place_text(here.place));
  }
  if (time_s_ - held_since_s_ >= settings_.flight.stop_after_s)
    return end(Outcome::kStopped, "held at " + place_text(place) + ", no open space found");
  if (is_stuck()) return end(Outcome::kStuck, "went in circles at " + place_text(place));
  if (time_s_ >= settings_.flight.time_max_s) end(Outcome::kTimeout, "time_max_s is over at " + place_text(place));
}

void Flight::end(Outcome outcome, std::string reason) {
  outcome_ = outcome;
  reason_ = std::move(reason);
}

}  // namespace adit::sim
