// How long it takes from a frame's stamp to what is made of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "adit/node/time.hpp"

namespace adit::node {

struct LatencyFigures {
  std::size_t count = 0;  ///< of the latencies that the figures are of
  double p50_s = 0.0;
  double p90_s = 0.0;
  double p99_s = 0.0;
  double max_s = 0.0;
};

/// Percentiles of the last kWindow latencies (at 30 Hz: half a minute). Allocates nothing.
class LatencyMeter {
 public:
  static constexpr std::size_t kWindow = 1024;

  /// Negative latencies (a stamp of the future: clocks that disagree) are counted apart.
  void add(Time_ns latency_ns) noexcept;
  void reset() noexcept { *this = LatencyMeter(); }

  /// Nearest-rank percentiles.
  [[nodiscard]] LatencyFigures figures() const noexcept;
  [[nodiscard]] std::int64_t count() const noexcept { return count_; }
  [[nodiscard]] std::int64_t future_count() const noexcept { return future_count_; }

 private:
  std::array<Time_ns, kWindow> last_ns_{};
  std::int64_t count_ = 0;
  std::int64_t future_count_ = 0;
};

}  // namespace adit::node
