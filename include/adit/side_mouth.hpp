// A passage that leaves to the side: too near the edge of the frame to be an opening ahead, but the wall is gone there.
#pragma once

#include <optional>

#include "adit/api.hpp"
#include "adit/range_memory.hpp"

namespace ADIT_API adit {

/// Watches the wall on one side, at the edge of the frame. Where it stays away for a while, a passage leaves to that
/// side; then this says whereto, until the vehicle has turned into it. For those who were told to prefer a side: a
/// drift that crosses is never a longer way than the one ahead. Allocates nothing.
class SideMouth {
 public:
  /// One frame on. @param profile  the smoothed ranges; @param side  1 to the right, -1 to the left; @param step  since
  /// the frame before.
  /// @return the azimuth to turn to while a mouth is taken, positive to the right; none otherwise.
  std::optional<double> update(const RangeProfile& profile, double side, const Step& step) noexcept;
  [[nodiscard]] bool taking() const noexcept { return taking_; }
  void reset() noexcept { *this = {}; }

 private:
  void watch(double beside_m, double forward_m) noexcept;

  double wall_m_ = 0.0;   ///< range of the wall at the frame's edge, smoothed over the way; 0: not known yet
  double known_m_ = 0.0;  ///< way over which it has been seen
  double gone_m_ = 0.0;   ///< way over which it has been away
  bool taking_ = false;
  double turned_rad_ = 0.0;  ///< into the mouth that is being taken
  double taking_s_ = 0.0;
};

}  // namespace adit
