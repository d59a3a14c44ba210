// Time as messages carry it. Nothing in this library reads a clock: who calls it says what time it is.
#pragma once

#include <cstdint>

namespace adit::node {

/// Nanoseconds on the line that stamps and clock share (ROS time: since 1970, or since the simulation began).
using Time_ns = std::int64_t;

inline constexpr Time_ns kSecond_ns = 1'000'000'000;

[[nodiscard]] constexpr double seconds_of(Time_ns time_ns) noexcept {
  return static_cast<double>(time_ns) / static_cast<double>(kSecond_ns);
}
[[nodiscard]] constexpr Time_ns time_of(double time_s) noexcept {
  return static_cast<Time_ns>(time_s * static_cast<double>(kSecond_ns));
}

}  // namespace adit::node
