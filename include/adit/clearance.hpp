// Which way keeps off the walls: free way and room to either side of each direction, from ranges and remembered walls.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "adit/api.hpp"
#include "adit/range_memory.hpp"

namespace ADIT_API adit {

/// Which way to take where the passage branches. kExplore keeps to the right: with turns at dead ends it comes through
/// every passage of a network without loops.
enum class Prefer { kStraight, kLeft, kRight, kExplore };
/// "straight", "left", "right", "explore".
[[nodiscard]] std::string_view to_string(Prefer prefer) noexcept;
/// The other way round; false and no change when the name is unknown.
[[nodiscard]] bool parse(std::string_view name, Prefer& prefer) noexcept;

/// Every constant of the steering; unit, range and source of each field stand in visit_fields() (fields.hpp).
struct SteeringConfig {
  Prefer prefer = Prefer::kStraight;
  double body_half_width_m = 0.25;
  double margin_m = 0.35;
  double clearance_m = 2.5;
  double look_ahead_m = 4.5;
  double clearance_weight = 6.0;
  double goal_weight = 1.0;
  double change_weight = 0.5;
  double stop_range_m = 1.6;
  double slow_range_m = 3.5;
  double turn_rate_rad_s = 0.6;
  double turn_min_rad = 1.0;
  double clear_range_m = 4.5;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const SteeringConfig& config);

/// One direction for each bin of the profile.
struct Ways {
  std::array<float, kRangeBins> free_m{};  ///< way that a body with its margin can go straight on
  std::array<float, kRangeBins> crowd{};   ///< how near walls come to the first look_ahead_m of it, 0 to 1
};

/// A stretch of directions that are open.
struct Gap {
  double azimuth_rad = 0.0;  ///< of its middle, weighted with the free way
  double free_m = 0.0;       ///< longest free way in it
  double half_width_rad = 0.0;
};
inline constexpr std::size_t kGapsMax = 8;

/// Free way and crowding of all directions. Allocates nothing.
[[nodiscard]] Ways ways_of(const SteeringConfig& config, const RangeProfile& profile,
                           std::span<const WallPoint> beside) noexcept;

/// Gaps, from left to right. @param gaps  at least kGapsMax. @return how many.
std::size_t gaps_of(const SteeringConfig& config, const RangeProfile& profile, const Ways& ways,
                    std::span<Gap> gaps) noexcept;

}  // namespace adit
