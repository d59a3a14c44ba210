// The controller node's logic: headings in, velocity commands out, and hover when nothing fresh is known.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/node/diagnosis.hpp"
#include "adit/node/latency.hpp"
#include "adit/node/parameters.hpp"
#include "adit/node/stamp_check.hpp"
#include "adit/node/velocity.hpp"
#include "adit/node/watchdog.hpp"

namespace adit::node {

/// What the controller needs of the message `open_space`.
struct OpenSpaceNews {
  Time_ns stamp_ns = 0;
  Status status = Status::kBadFrame;
  bool is_turning = false;  ///< the navigator turns in place at a dead end
};

/// What the message `heading` says.
struct HeadingNews {
  Time_ns stamp_ns = 0;
  double forward_m_s = 0.0;
  double yaw_rate_rad_s = 0.0;  ///< positive to the left
};

/// A heading is passed on once, when it comes, if it is fresh; between headings nothing is repeated. tick() hovers for
/// as long as nothing fresh is known, so that an autopilot hears a setpoint at the rate of the ticks.
class Control {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit Control(const ControlConfig& config = {});

  [[nodiscard]] const ControlConfig& config() const noexcept { return config_; }
  /// Keeps what it knows of the stream. @throws as the constructor; then nothing is changed.
  void configure(const ControlConfig& config);
  /// The same by name: set() all that is to change, then apply(). See Perception.
  [[nodiscard]] std::vector<Parameter> parameters() const;
  [[nodiscard]] std::string set(const std::string& name, const ParameterValue& value);
  void apply() { configure(wanted_); }

  void take(const OpenSpaceNews& news, Time_ns now_ns) noexcept;
  /// The command for the vehicle: hover when the watchdog says so; nothing when the heading is no news.
  [[nodiscard]] std::optional<VelocityCommand> take(const HeadingNews& news, Time_ns now_ns) noexcept;
  /// Hover, or nothing while all is well. Call it at 10 Hz or more.
  [[nodiscard]] std::optional<VelocityCommand> tick(Time_ns now_ns) noexcept;

  /// From stamp to command, of the commands that were passed on.
  [[nodiscard]] const LatencyMeter& latency() const noexcept { return latency_; }
  [[nodiscard]] std::int64_t refused_headings() const noexcept { return refused_headings_; }
  [[nodiscard]] std::int64_t hover_count() const noexcept { return hover_count_; }
  [[nodiscard]] Diagnosis diagnosis(Time_ns now_ns);
  /// "following", or why it hovers.
  [[nodiscard]] std::string alarm_text(Time_ns now_ns);

 private:
  [[nodiscard]] VelocityCommand hover(Time_ns now_ns) noexcept;

  ControlConfig config_, wanted_;
  Watchdog watchdog_;
  StampCheck image_stamps_, heading_stamps_;
  LatencyMeter latency_;
  Status last_status_ = Status::kBadFrame;
  std::int64_t passed_on_ = 0, refused_headings_ = 0;
  std::int64_t hover_count_ = 0;  ///< times that it began to hover
  bool is_hovering_ = false;
};

}  // namespace adit::node
