// Watchdog: is what the vehicle would act on still true?
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "adit/finder.hpp"
#include "adit/node/control_config.hpp"
#include "adit/node/time.hpp"

namespace adit::node {

/// What keeps the vehicle from moving.
enum class Alarm : std::uint8_t {
  kNone,
  kNoImage,       ///< none yet, or none for hover_after_s
  kOldImages,     ///< images come, but their stamps are of the past: a slow link, or clocks that disagree
  kFutureImages,  ///< ... of the future
  kFrozen,        ///< the camera sends the same frame again and again
  kNoOpening,     ///< images are fresh, and no opening was found for hover_after_s
  kNoHeading,     ///< openings are found, but no heading comes with them
};
/// "none", "no image", ...
[[nodiscard]] std::string_view to_string(Alarm alarm) noexcept;

/// In what state it is.
enum class Watch : std::uint8_t {
  kFresh,  ///< go
  kHover,
  kError,  ///< hover, and somebody should look: it has lasted for error_after_s
};

struct WatchdogState {
  Watch watch = Watch::kHover;
  Alarm alarm = Alarm::kNoImage;
  double for_s = 0.0;  ///< how long there has been nothing to act on
};

/// Time is passed in: it may stand still, jump or run backwards. After a jump backwards nothing that was seen before
/// counts as fresh. Allocates nothing.
class Watchdog {
 public:
  explicit Watchdog(const ControlConfig& config) noexcept : config_(config) {}
  void configure(const ControlConfig& config) noexcept { config_ = config; }

  /// An image was judged. @param can_follow  an opening was found, or what stands for one.
  void see_image(Time_ns stamp_ns, Status status, bool can_follow, Time_ns now_ns) noexcept;
  void see_heading(Time_ns now_ns) noexcept;
  [[nodiscard]] WatchdogState check(Time_ns now_ns) noexcept;

  [[nodiscard]] std::int64_t clock_jumps_back() const noexcept { return clock_jumps_back_; }
  [[nodiscard]] std::int64_t old_images() const noexcept { return old_images_; }
  [[nodiscard]] std::int64_t future_images() const noexcept { return future_images_; }

 private:
  void advance(Time_ns now_ns) noexcept;
  [[nodiscard]] bool is_recent(const std::optional<Time_ns>& time_ns, Time_ns now_ns) const noexcept;
  [[nodiscard]] Alarm alarm(Time_ns now_ns) const noexcept;

  ControlConfig config_;
  std::optional<Time_ns> now_ns_;      ///< the latest time that was passed in
  std::optional<Time_ns> begin_ns_;    ///< of waiting: the first time passed in, or the last moment all was well
  std::optional<Time_ns> arrival_ns_;  ///< when the last image came, however old
  std::optional<Time_ns> image_ns_;    ///< stamp of the last fresh image
  std::optional<Time_ns> found_ns_;    ///< stamp of the last one that could be followed
  std::optional<Time_ns> heading_ns_;  ///< when the last heading came
  Alarm stamp_alarm_ = Alarm::kNone;   ///< of the last image
  bool is_frozen_ = false;
  std::int64_t clock_jumps_back_ = 0, old_images_ = 0, future_images_ = 0;
};

}  // namespace adit::node
