// OpeningTracker: openings over time, in bearing space, so that one bad frame turns nobody round.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "adit/api.hpp"
#include "adit/finder.hpp"

namespace ADIT_API adit {

/// Every constant of the tracker; unit, range and source of each field stand in visit_fields() (fields.hpp).
struct TrackerConfig {
  double gate_rad = 0.2;
  double bearing_smoothing_s = 0.2;
  double trust_s = 0.3;
  double forget_s = 0.7;
  double switch_ratio = 1.5;
  double switch_after_s = 0.5;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const TrackerConfig& config);

/// An opening that was seen in several frames.
struct Track {
  std::uint32_t id = 0;  ///< never given twice until reset()
  Bearing bearing;       ///< now, smoothed; azimuth as in the frame
  double half_width_rad = 0.0;
  double score = 0.0;     ///< 0 to 1: grows to that of its openings while it is seen, falls to 0 while it is not
  double age_s = 0.0;     ///< since it was first seen
  double unseen_s = 0.0;  ///< since it was last seen
};
inline constexpr std::size_t kTracksMax = 12;

/// Associates the openings of each frame with those before. Allocates nothing.
class OpeningTracker {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit OpeningTracker(const TrackerConfig& config = {});

  [[nodiscard]] const TrackerConfig& config() const noexcept { return config_; }

  /// A frame. @param time_s  since the last call, >= 0. @param yaw_rad  how far the vehicle turned since, positive to
  /// the left; 0 when it is not known: the gate then has to be wide enough for it.
  void update(const OpenSpace& open_space, double time_s, double yaw_rad) noexcept;
  void reset() noexcept;

  /// All tracks, in no order.
  [[nodiscard]] std::span<const Track> tracks() const noexcept { return {tracks_.data(), count_}; }
  /// The one to follow: it changes only when another has been better by switch_ratio for switch_after_s, or when it is
  /// lost. Null when there is none.
  [[nodiscard]] const Track* chosen() const noexcept { return find(chosen_id_); }

 private:
  [[nodiscard]] const Track* find(std::uint32_t id) const noexcept;
  Track* nearest(double azimuth_rad, const std::array<bool, kTracksMax>& taken) noexcept;
  void see(Track& track, const Opening& opening, double time_s) noexcept;
  void start(const Opening& opening) noexcept;
  void forget() noexcept;
  void choose(double time_s) noexcept;

  TrackerConfig config_;
  std::array<Track, kTracksMax> tracks_{};
  std::size_t count_ = 0;
  std::uint32_t last_id_ = 0;
  std::uint32_t chosen_id_ = 0;
  std::uint32_t rival_id_ = 0;
  double rival_s_ = 0.0;
};

}  // namespace adit
