// Times and what they say.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace adit::tools {

/// Times of one thing, in milliseconds.
class Samples {
 public:
  void add(double time_ms) { times_ms_.push_back(time_ms); }
  [[nodiscard]] std::size_t count() const { return times_ms_.size(); }
  /// The smallest time that at least `share` of the samples do not exceed (nearest rank); share in (0, 1].
  /// 0 without samples.
  [[nodiscard]] double percentile_ms(double share) const;
  [[nodiscard]] double median_ms() const { return percentile_ms(0.5); }

 private:
  std::vector<double> times_ms_;
};

/// What counts as time.
enum class TimeKind {
  kPassed,  ///< on the wall: what a robot waits
  kUsed,    ///< that this thread had a core: what a frame costs, also on a machine that is not idle
};

/// Milliseconds on a clock that only goes forward.
[[nodiscard]] double now_ms(TimeKind kind = TimeKind::kPassed);

/// Ties this thread to the core it is on and returns its number, or -1 where that is not allowed.
int pin_to_core();

/// How often the system took the core away from this thread so far.
[[nodiscard]] std::int64_t interruptions();

[[nodiscard]] std::string cpu_model();
[[nodiscard]] std::string compiler();

}  // namespace adit::tools
