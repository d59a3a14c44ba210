// What is remembered of the column ranges: smoothed over time, carried along as the vehicle moves, kept a little longer
// when it leaves the frame at the sides.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "adit/api.hpp"
#include "adit/column_range.hpp"

namespace ADIT_API adit {

/// Every constant of the memory; unit, range and source of each field stand in visit_fields() (fields.hpp).
struct RangeMemoryConfig {
  double range_smoothing_s = 0.15;
  double veil_rise_s = 30.0;
  double keep_s = 6.0;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const RangeMemoryConfig& config);

/// How the vehicle moved since the last frame.
struct Step {
  double time_s = 0.0;
  double yaw_rad = 0.0;  ///< positive to the left
  double forward_m = 0.0;
};

/// A place on a wall, seen from above, in the body's frame.
struct WallPoint {
  float forward_m = 0.0f;
  float right_m = 0.0f;
  float age_s = 0.0f;
};

/// Allocates nothing.
class RangeMemory {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit RangeMemory(const RangeMemoryConfig& config = {});

  /// The vehicle moved: what is remembered moves against it.
  void move(const Step& step) noexcept;
  /// Takes a frame's ranges in. @param time_s since the last frame that was taken in.
  void take(const RangeProfile& profile, double time_s) noexcept;
  void reset() noexcept;

  [[nodiscard]] bool empty() const noexcept { return !profile_.valid; }
  /// The smoothed profile; azimuths as in the frame.
  [[nodiscard]] const RangeProfile& profile() const noexcept { return profile_; }
  /// Walls that left the frame at its sides, no longer than keep_s ago.
  [[nodiscard]] std::span<const WallPoint> beside() const noexcept { return {beside_.data(), beside_count_}; }
  /// What dust throws back, as a share of reach_light: the smallest share seen, forgotten slowly.
  [[nodiscard]] double veil_share() const noexcept { return veil_share_; }

 private:
  void turn_profile(double yaw_rad) noexcept;
  void keep_edges(const RangeProfile& profile) noexcept;
  void keep(double azimuth_rad, double range_m) noexcept;

  static constexpr std::size_t kBesideMax = 96;
  RangeMemoryConfig config_;
  RangeProfile profile_;  ///< range_m smoothed in its logarithm
  double veil_share_ = 0.0;
  bool veil_known_ = false;
  double moved_ = 0.0;  ///< since edges were kept last, in steps
  std::array<WallPoint, kBesideMax> beside_{};
  std::size_t beside_count_ = 0;
};

}  // namespace adit
