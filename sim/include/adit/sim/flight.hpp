// The loop: the world is seen, the frame is judged, the vehicle turns, and what happened is written down.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/navigator.hpp"
#include "adit/sim/lidar.hpp"
#include "adit/sim/network.hpp"
#include "adit/sim/occupancy.hpp"
#include "adit/sim/truth.hpp"
#include "adit/sim/vehicle.hpp"

namespace adit::sim {

/// Who turns what the camera shows into commands.
enum class Pilot : std::uint8_t {
  kByMethod,   ///< the published controller for the published method, the navigator for every other
  kPublished,  ///< finder and heading controller in a row, at full speed while they answer: as in the paper
  kNavigator,  ///< the core's Navigator
};
[[nodiscard]] std::string_view to_string(Pilot pilot) noexcept;
/// The other way round; false and no change when the name is unknown.
[[nodiscard]] bool parse(std::string_view name, Pilot& pilot) noexcept;

/// How a flight runs; unit, range and source of each field stand in visit_fields() (flight_fields.hpp).
struct FlightConfig {
  Pilot pilot = Pilot::kByMethod;
  double speed_m_s = 1.0;
  double time_max_s = 120.0;
  double physics_rate_hz = 200.0;
  double camera_rate_hz = 30.0;
  int camera_delay_frames = 1;
  double drop_fraction = 0.01;
  double repeat_fraction = 0.005;
  double stop_after_s = 10.0;
  double stuck_radius_m = 2.0;
  double stuck_after_m = 20.0;
  double start_jitter_m = 0.3;
  double start_yaw_jitter_deg = 5.0;
  double map_cell_m = 0.1;
};

[[nodiscard]] std::optional<std::string> fault_of(const FlightConfig& config);

/// All that flies: every constant of it, section by section.
struct FlightSettings {
  FlightConfig flight;
  VehicleConfig vehicle;
  TruthConfig truth;
  LidarConfig lidar;
  ImuConfig imu;
  FinderConfig finder;
  HeadingConfig heading;
  ColumnRangeConfig column_range;  ///< this and the next four: of the navigator
  RangeMemoryConfig range_memory;
  TrackerConfig tracker;
  SteeringConfig steering;
  FrameWatchConfig frame_watch;
  LensWatchConfig lens_watch;
  std::uint64_t seed = 1;
};

/// What the vehicle looks through: a renderer, or a stand-in in tests.
class Eye {
 public:
  virtual ~Eye() = default;
  [[nodiscard]] virtual const Camera& camera() const = 0;
  [[nodiscard]] virtual CameraPose pose(const VehicleState& vehicle) const = 0;
  /// Takes a frame. It stays valid until the next call.
  /// @param seed  of this frame's noise.
  virtual ImageView look(const VehicleState& vehicle, double stamp_s, std::uint64_t seed) = 0;
  /// Whether the vehicle's lamps are to be on in even frames and off in odd ones, and frames judged in pairs.
  [[nodiscard]] virtual bool flashes() const { return false; }
  /// For the frames from now on.
  virtual void switch_lamps(bool /*on*/) {}
  /// Does both, which have nothing to do with each other: beside each other where it has threads for that.
  virtual void both(const std::function<void()>& one, const std::function<void()>& other) {
    one();
    other();
  }
};

/// How a flight ended.
enum class Outcome : std::uint8_t {
  kGoal,
  kCollided,  ///< the body touched rock
  kStopped,   ///< it was told to hold for stop_after_s
  kStuck,     ///< it flew on and got nowhere
  kReturned,  ///< it left through the mouth by which it came
  kTimeout,   ///< time_max_s is over
};
[[nodiscard]] std::string_view to_string(Outcome outcome) noexcept;

/// What became of the frame that the camera took.
enum class Delivery : std::uint8_t { kFresh, kDropped, kRepeated };
[[nodiscard]] std::string_view to_string(Delivery delivery) noexcept;

/// One frame of a flight. Pose and truth are those of the moment the frame was taken, and so is what perception made
/// of it, though the vehicle learns that camera_delay_frames later; the command is the one in force from then on.
struct FlightRow {
  std::int64_t frame = 0;
  double stamp_s = 0.0;
  VehicleState vehicle;
  Truth truth;
  Delivery delivery = Delivery::kFresh;
  bool lamps_on = true;               ///< when the frame was taken that was delivered
  Status status = Status::kBadFrame;  ///< meaningless for dropped frames, as are the next six
  double confidence = 0.0;
  Pixel centroid_px;
  NormalisedPoint point;
  Bearing bearing;
  double area_fraction = 0.0;
  SightFlags flags;
  HeadingCommand command;
  double speed_scale = 1.0;            ///< of the command: share of speed_m_s
  std::optional<Manoeuvre> manoeuvre;  ///< of the command; nothing: the published controller flies, and knows none
  std::optional<Track> track;          ///< the opening that is followed; nothing: none, or nobody keeps track
};

/// One flight, frame by frame: while (flight.step()) use flight.row().
class Flight {
 public:
  /// @param world, scene, eye  must outlive the flight.
  /// @throws std::invalid_argument naming the field, the value and the range, or why the start is impossible.
  Flight(const FlightSettings& settings, const World& world, const RayScene& scene, Eye& eye);
  ~Flight();

  /// Takes a frame, judges it, and flies until the next. False when the flight is over; then there is no new row.
  bool step();

  /// Other settings of perception and steering, from the next frame on and as if it began there: what was remembered of
  /// the way is gone. Frames that are still on their way to the pilot stay what they were judged to be.
  /// @throws std::invalid_argument naming the field, the value and the range; nothing is changed then.
  void change(const NavigatorConfig& config);

  [[nodiscard]] const FlightRow& row() const noexcept { return row_; }
  /// The frame of row(), for films; valid until the next step(). The same pixels that perception got.
  [[nodiscard]] const ImageView& frame() const noexcept { return frame_; }
  /// All that perception said of it.
  [[nodiscard]] const OpenSpace& open_space() const noexcept { return open_space_; }
  /// Null when the published controller flies.
  [[nodiscard]] const Navigator* navigator() const noexcept { return navigator_ ? &*navigator_ : nullptr; }

  /// Empty while it flies.
  [[nodiscard]] std::optional<Outcome> outcome() const noexcept { return outcome_; }
  /// The outcome in a few words: where, and what was touched.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }
  /// After a collision: the smallest horizontal range from where the body came to rest, m; NaN otherwise.
  [[nodiscard]] double touched_side_m() const noexcept { return touched_side_m_; }
  [[nodiscard]] double time_s() const noexcept { return time_s_; }
  [[nodiscard]] double distance_m() const noexcept { return distance_m_; }
  [[nodiscard]] const VehicleState& vehicle() const noexcept { return vehicle_.state(); }
  [[nodiscard]] const OccupancyGrid& map() const noexcept { return map_; }
  [[nodiscard]] const Network& network() const noexcept { return network_; }
  [[nodiscard]] const Camera& camera() const { return eye_->camera(); }
  [[nodiscard]] const FlightSettings& settings() const noexcept { return settings_; }

  /// Sensors of the last interval, for who wants to keep them: swept and sampled only after record_sensors(true).
  void record_sensors(bool on) noexcept { records_sensors_ = on; }
  [[nodiscard]] const std::vector<ImuSample>& imu_samples() const noexcept { return imu_samples_; }
  [[nodiscard]] const std::optional<Scan>& scan() const noexcept { return scan_; }

 private:
  void engage(const FlightSettings& settings);
  void take_frame();
  [[nodiscard]] Sight judged();
  [[nodiscard]] Sight judged_and_measured();
  void deliver();
  void measure();
  void survey();
  void sweep();
  [[nodiscard]] double speed_m_s() const noexcept;
  bool fly_to_next_frame();
  [[nodiscard]] bool is_stuck();
  void judge_progress();
  void end(Outcome outcome, std::string reason);

  struct Arrival {
    double stamp_s = 0.0;
    bool dropped = false;
    Sight sight;
    Motion motion;  ///< when the frame was taken
  };

  FlightSettings settings_;
  Eye* eye_;
  Network network_;
  Vehicle vehicle_;
  Surveyor surveyor_;
  std::optional<AxisPlace> start_;
  std::optional<OpenSpaceFinder> finder_;  ///< this and the controller, or the navigator
  std::optional<HeadingController> controller_;
  std::optional<Navigator> navigator_;
  Lidar lidar_;
  Imu imu_;
  OccupancyGrid map_;
  Random delivery_random_;
  double physics_step_s_;
  int physics_steps_;

  double time_s_ = 0.0;
  double distance_m_ = 0.0;
  std::int64_t frames_ = 0;
  bool has_been_inside_ = false;
  std::deque<Arrival> on_the_way_;
  HeadingCommand command_;
  double speed_scale_ = 1.0;
  Manoeuvre manoeuvre_ = Manoeuvre::kWait;
  double held_since_s_ = 0.0;
  std::deque<std::pair<double, Eigen::Vector3d>> track_;  ///< distance flown and place, of the last stuck_after_m
  bool records_sensors_ = false;
  std::vector<ImuSample> imu_samples_;
  std::optional<Scan> scan_;

  FlightRow row_;
  ImageView frame_;
  /// Of an eye that flashes: the last frame with the lamps off and the last with them on, and which of them is frame_.
  std::vector<std::uint8_t> kept_[2];
  bool is_lit_ = true;
  OpenSpace open_space_;
  std::optional<Outcome> outcome_;
  std::string reason_;
  double touched_side_m_ = kUnknown;
};

}  // namespace adit::sim
