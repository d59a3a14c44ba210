#include "adit/node/latency.hpp"

#include <algorithm>
#include <cmath>

namespace adit::node {

void LatencyMeter::add(Time_ns latency_ns) noexcept {
  if (latency_ns < 0) {
    ++future_count_;
    return;
  }
  last_ns_[static_cast<std::size_t>(count_++) % kWindow] = latency_ns;
}

LatencyFigures LatencyMeter::figures() const noexcept {
  LatencyFigures figures;
  figures.count = static_cast<std::size_t>(std::min<std::int64_t>(count_, kWindow));
  if (figures.count == 0) return figures;
  auto sorted = last_ns_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(figures.count);
  std::sort(sorted.begin(), end);
  const auto at = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(figures.count)));
    return seconds_of(sorted[std::clamp<std::size_t>(rank, 1, figures.count) - 1]);
  };
  figures.p50_s = at(0.50);
  figures.p90_s = at(0.90);
  figures.p99_s = at(0.99);
  figures.max_s = at(1.0);
  return figures;
}

}  // namespace adit::node
