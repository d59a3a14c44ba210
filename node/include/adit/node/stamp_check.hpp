// What is wrong with a stream's stamps: duplicates, frames out of order, clocks that jump, bags that start again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "adit/node/time.hpp"

namespace adit::node {

enum class StampVerdict : std::uint8_t {
  kFresh,
  kMissing,    ///< 0: the driver does not stamp
  kDuplicate,  ///< as the last one
  kReordered,  ///< a little earlier than the last one
  kRestarted,  ///< much earlier: a bag that starts again, a clock set back. The next ones count from here
  kGap,        ///< much later: frames are missing, or the clock was set forward
};
inline constexpr std::size_t kStampVerdictCount = 6;
/// "fresh", "missing", "duplicate", "reordered", "restarted", "gap".
[[nodiscard]] std::string_view to_string(StampVerdict verdict) noexcept;

/// Judges each stamp by those before. Allocates nothing.
class StampCheck {
 public:
  /// @param jump_after_s  > 0: what is further off than this, earlier or later, is a jump.
  explicit StampCheck(double jump_after_s = 0.5) noexcept : jump_after_ns_(time_of(jump_after_s)) {}

  StampVerdict judge(Time_ns stamp_ns) noexcept;
  void reset() noexcept;

  [[nodiscard]] std::int64_t count(StampVerdict verdict) const noexcept {
    return counts_[static_cast<std::size_t>(verdict)];
  }
  /// Frames that a regular stream would have had between those that came. Those lost in a gap are not counted.
  [[nodiscard]] std::int64_t lost() const noexcept { return lost_; }
  /// Median of the last intervals; 0 before there are three.
  [[nodiscard]] double interval_s() const noexcept;

 private:
  static constexpr std::size_t kIntervals = 15;  // half a second of a camera at 30 Hz

  StampVerdict judged(Time_ns stamp_ns) const noexcept;
  void take_interval(Time_ns interval_ns) noexcept;

  Time_ns jump_after_ns_;
  std::optional<Time_ns> last_ns_;
  std::array<Time_ns, kIntervals> intervals_ns_{};
  std::size_t interval_count_ = 0;
  std::array<std::int64_t, kStampVerdictCount> counts_{};
  std::int64_t lost_ = 0;
};

/// May the frame be used? Duplicates and frames out of order may not.
[[nodiscard]] constexpr bool is_usable(StampVerdict verdict) noexcept {
  return verdict != StampVerdict::kDuplicate && verdict != StampVerdict::kReordered;
}

}  // namespace adit::node
