// HeadingController: bearing in, yaw rate out. Time is passed in, never read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "adit/api.hpp"
#include "adit/camera.hpp"
#include "adit/finder.hpp"

namespace ADIT_API adit {

/// Every constant of the controller; unit, range and source of each field stand in visit_fields() (fields.hpp).
struct HeadingConfig {
  double gain_per_s = 1.0;
  double yaw_rate_max_rad_s = 0.8;
  double yaw_acceleration_max_rad_s2 = 2.0;
  double dead_band_rad = 0.02;
  double hold_after_s = 0.5;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const HeadingConfig& config);

/// What the vehicle should do about its heading.
enum class HeadingState : std::uint8_t {
  kSteer,  ///< a fresh bearing is being followed
  kCoast,  ///< the last bearing is younger than hold_after_s, but this frame had none: the rate runs down to zero
  kHold,   ///< no fresh bearing for hold_after_s, or never one: rate zero
};
[[nodiscard]] std::string_view to_string(HeadingState state) noexcept;

/// A command in the body frame (x forward, y left, z up), REP 103.
struct HeadingCommand {
  HeadingState state = HeadingState::kHold;
  double yaw_rate_rad_s = 0.0;  ///< positive counter-clockwise, seen from above: to the left
};

/// The one place where the sign turns: azimuth is positive to the right, yaw positive to the left.
[[nodiscard]] constexpr double yaw_of_azimuth(double azimuth_rad) noexcept { return -azimuth_rad; }

/// Proportional steering with a dead band (taken off the azimuth, so that nothing jumps at its edge), a limit on the
/// rate and on its change, and a hold.
/// A command is made from the frame it is called with, or it is on its way to zero: an old bearing is never used again.
/// The first frame, and the first after a gap of hold_after_s or more, steers from rate zero with no time passed: its
/// rate is 0.
class HeadingController {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit HeadingController(const HeadingConfig& config = {});

  [[nodiscard]] const HeadingConfig& config() const noexcept { return config_; }

  /// A new judged frame.
  /// @param stamp_s  when it was taken. A stamp that is not later than that of the last frame, or not finite, is stale:
  ///                 its bearing is not used. It says nothing about the time, so it counts as one more interval like
  ///                 the last: a camera that hangs and sends one frame for ever is coasted on, then held on.
  ///                 After a jump backwards by more than hold_after_s (a bag that starts again) the controller starts
  ///                 afresh from rate zero.
  HeadingCommand update(const OpenSpace& open_space, double stamp_s) noexcept;

  /// The command when no new frame has come by now_s (a watchdog's question), on the same time line as the stamps. It
  /// lets the rate run down, so ask only when a frame is overdue. A frame taken before the last tick is still used, but
  /// the time up to the tick is spent: the rate cannot change by more than the limit allows from the tick on.
  HeadingCommand tick(double now_s) noexcept;

  /// Forgets everything: the next command starts from rate zero.
  void reset() noexcept;

 private:
  HeadingCommand stale() noexcept;
  HeadingCommand coast_or_hold(double elapsed_s) noexcept;
  double advance_to(double time_s) noexcept;
  double limited(double wanted_rad_s, double elapsed_s) const noexcept;

  HeadingConfig config_;
  std::optional<double> last_stamp_s_;  ///< of the last frame that was not stale
  std::optional<double> last_time_s_;   ///< the latest stamp or tick
  std::optional<double> last_found_s_;  ///< stamp of the last bearing that was used
  double interval_s_ = 0.0;             ///< the last time that passed between two calls
  double stale_s_ = 0.0;                ///< time that stale calls since then stand for
  double yaw_rate_rad_s_ = 0.0;         ///< the last command
};

}  // namespace adit
