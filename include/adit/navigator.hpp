// Navigator: finder, ranges, tracker, steering and controller in a row, for sequences: what a robot runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "adit/api.hpp"
#include "adit/clearance.hpp"
#include "adit/column_range.hpp"
#include "adit/finder.hpp"
#include "adit/frame_watch.hpp"
#include "adit/heading.hpp"
#include "adit/lens_watch.hpp"
#include "adit/range_memory.hpp"
#include "adit/side_mouth.hpp"
#include "adit/tracker.hpp"

namespace ADIT_API adit {

/// All that a navigator is made with; each section has its own fields (fields.hpp) and its own section in YAML.
struct NavigatorConfig {
  FinderConfig finder;
  HeadingConfig heading;
  ColumnRangeConfig column_range;
  RangeMemoryConfig range_memory;
  TrackerConfig tracker;
  SteeringConfig steering;
  FrameWatchConfig frame_watch;
  LensWatchConfig lens_watch;
};

/// What the navigator is about.
enum class Manoeuvre : std::uint8_t {
  kWait,    ///< nothing usable is seen: hold
  kFollow,  ///< an open way is followed
  kTurn,    ///< nothing open ahead: it turns in place towards the more open side
  kGiveUp,  ///< it has turned all the way round and found nothing: hold
};
[[nodiscard]] std::string_view to_string(Manoeuvre manoeuvre) noexcept;

/// What is wrong with a frame's stamp. The command is made all the same: see Navigator::steer.
enum class StampFault : std::uint8_t {
  kNone,
  kNotLater,   ///< as the last one, a little earlier, or no number: the frame is not used, the command runs down
  kBackwards,  ///< earlier by more than hold_after_s: a recording that starts again; so does the navigator
  kJump,       ///< later by more than hold_after_s: frames are missing; steering starts again from rate zero
};
[[nodiscard]] std::string_view to_string(StampFault fault) noexcept;

/// What the caller knows of the vehicle's motion. What is not known is taken from the navigator's own commands.
struct Motion {
  std::optional<double> yaw_rate_rad_s;  ///< positive to the left, of a gyroscope
  std::optional<double> speed_m_s;       ///< forward, measured or commanded
};

/// What one frame showed, judged alone.
struct Sight {
  OpenSpace open_space;
  RangeProfile profile;
};

/// What the vehicle should do now.
struct NavigatorCommand {
  HeadingCommand heading;    ///< yaw rate, and whether it is held
  double speed_scale = 0.0;  ///< share of the wanted speed, 0 to 1
  Manoeuvre manoeuvre = Manoeuvre::kWait;
  Status status = Status::kBadFrame;  ///< of the frame, with what only a sequence shows
  StampFault stamp_fault = StampFault::kNone;
  double target_rad = 0.0;  ///< azimuth that is steered to, positive to the right
  double goal_rad = 0.0;    ///< azimuth of the middle of the gap that was chosen
  double free_m = 0.0;      ///< free way straight ahead, on the pseudo-range's scale
};

/// What a robot runs. look() and steer() are apart for cameras whose frames are judged elsewhere than steered by;
/// update() does both. Allocates nothing once the frame's size is known.
class Navigator {
 public:
  /// Frames of any size. @throws std::invalid_argument naming the field, the value and the range.
  explicit Navigator(const NavigatorConfig& config = {});
  /// Frames of the camera's size only.
  Navigator(const NavigatorConfig& config, const Camera& camera);

  [[nodiscard]] const NavigatorConfig& config() const noexcept { return config_; }

  /// Judges a frame; frames in the order of their taking, for what only a sequence shows (frame_watch.hpp).
  [[nodiscard]] Sight look(const ImageView& frame) noexcept;
  /// The same of a pair of frames, lamp on and lamp off, `frame` the later one.
  [[nodiscard]] Sight look_flash(const ImageView& frame, const ImageView& before) noexcept;
  /// As look(), and the pictures of its stages. Allocates. @throws std::bad_alloc
  [[nodiscard]] Sight look(const ImageView& frame, StageImages& images);

  /// Judges by what is known of the vehicle's lamp (lamp.hpp), and goes on learning it if asked. Method `adit`.
  /// @throws std::invalid_argument for a pattern that is none.
  void use_lamp(const LampPattern& known, bool learn);
  [[nodiscard]] LampPattern lamp() const noexcept { return lamp_ ? lamp_->pattern() : known_lamp_; }

  /// Takes what was seen at stamp_s and says what to do. Stamps as for HeadingController::update.
  NavigatorCommand steer(const Sight& sight, double stamp_s, const Motion& motion = {}) noexcept;
  NavigatorCommand update(const ImageView& frame, double stamp_s, const Motion& motion = {}) noexcept {
    return steer(look(frame), stamp_s, motion);
  }
  /// No new frame has come by now_s. As HeadingController::tick; the vehicle goes on slowing down.
  NavigatorCommand tick(double now_s) noexcept;
  void reset() noexcept;

  [[nodiscard]] const OpeningTracker& tracker() const noexcept { return tracker_; }
  [[nodiscard]] const LensWatch& lens_watch() const noexcept { return lens_watch_; }
  [[nodiscard]] const RangeMemory& ranges() const noexcept { return memory_; }
  [[nodiscard]] const Ways& ways() const noexcept { return ways_; }

 private:
  Step step_to(double stamp_s, const Motion& motion) noexcept;
  void choose_gap(const Step& step) noexcept;
  std::optional<double> side_mouth(const Step& step) noexcept;
  double choose_target() const noexcept;
  void count_refusals(const OpenSpace& open_space, double time_s) noexcept;
  void begin_turn() noexcept;
  NavigatorCommand follow(double stamp_s, double time_s) noexcept;
  NavigatorCommand turn(double stamp_s) noexcept;
  NavigatorCommand hold(double stamp_s) noexcept;
  NavigatorCommand held() noexcept;
  StampFault fault_of_stamp(double stamp_s) const noexcept;
  double speed_scale() const noexcept;
  double free_ahead_m() const noexcept;

  Sight finish_look(const ImageView& frame, const OpenSpace& open_space, bool learn) noexcept;
  void watch_lens(const ImageView& frame, Sight& sight) noexcept;
  void learn_lamp(const ImageView& frame) noexcept;

  NavigatorConfig config_;
  OpenSpaceFinder finder_;
  std::optional<Camera> camera_;
  LampPattern known_lamp_;
  bool learns_lamp_ = false;
  std::optional<LampModel> lamp_;  ///< made at the first frame, whose size it needs
  FrameWatch watch_;
  LensWatch lens_watch_;
  ColumnRange column_range_;
  RangeMemory memory_;
  SideMouth side_mouth_;
  OpeningTracker tracker_;
  HeadingController controller_;
  Ways ways_;

  std::optional<double> last_stamp_s_;
  NavigatorCommand command_;
  Manoeuvre manoeuvre_ = Manoeuvre::kWait;
  bool has_goal_ = false;
  double goal_rad_ = 0.0, target_rad_ = 0.0;
  double rival_s_ = 0.0;
  double blocked_s_ = 0.0;
  double refused_s_ = 0.0;   ///< since the last opening worth trust, or the last turn
  double trust_ = 0.0;       ///< confidence of the openings seen, smoothed
  double turned_rad_ = 0.0;  ///< in this turn
  double turn_sign_ = 0.0;   ///< of the yaw rate
};

}  // namespace adit
