// How near the rock is, column by column: a photometric pseudo-range from the brightness of the robot's own light.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/api.hpp"
#include "adit/camera.hpp"
#include "adit/image.hpp"

namespace ADIT_API adit {

/// Every constant of the column range; unit, range and source of each field stand in visit_fields() (fields.hpp).
struct ColumnRangeConfig {
  double display_gamma = 2.2;
  double fall_off_exponent = 5.0;
  double band_low_deg = -4.0;
  double band_high_deg = 10.0;
  double camera_height_m = 1.0;
  double range_min_m = 0.4;
  double range_max_m = 12.0;
  double veil_per_extinction_m = 0.45;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const ColumnRangeConfig& config);

/// Columns of the frame are gathered in bins of equal azimuth.
inline constexpr int kRangeBins = 64;

/// What the robot's own light says of the rock about the horizon. Plain numbers: copying it allocates nothing.
struct RangeProfile {
  bool valid = false;                       ///< false: no frame, or nothing is lit
  double azimuth_first_rad = 0.0;           ///< middle of bin 0, the leftmost
  double azimuth_step_rad = 0.0;            ///< from bin to bin, > 0
  std::array<float, kRangeBins> light{};    ///< linear, without the lamp's and the lens's fall-off; white is 1
  std::array<float, kRangeBins> range_m{};  ///< pseudo-range, range_min_m to range_max_m
  double reach_light = 0.0;  ///< light of the same rock at 1 m, square to the lamp: the scale of the ranges
  double veil_share = 0.0;   ///< what this frame alone says of the veil ahead, as a share of reach_light

  [[nodiscard]] double azimuth_rad(int bin) const noexcept { return azimuth_first_rad + azimuth_step_rad * bin; }
};

/// Pseudo-range r = sqrt(I0 * albedo / (pi * L)) per bin of columns: rock that a lamp at the camera lights is the
/// darker the further it is. I0 * albedo * exposure is not known and changes with the automatic exposure; it is
/// measured anew in each frame from the floor, whose range follows from the camera's height. Each frame is measured
/// alone; allocates nothing once sized.
class ColumnRange {
 public:
  /// Frames of any size, seen by an ideal pinhole of this horizontal field of view, deg.
  /// @throws std::invalid_argument naming the field, the value and the range.
  ColumnRange(const ColumnRangeConfig& config, double assumed_hfov_deg, int grey16_depth_bits);
  /// Frames of the camera's size only.
  ColumnRange(const ColumnRangeConfig& config, const Camera& camera, int grey16_depth_bits);

  [[nodiscard]] const ColumnRangeConfig& config() const noexcept { return config_; }
  /// Prepares for frames of this size; measure() does so by itself at the first frame of a new size.
  /// @throws std::bad_alloc
  void reserve(int width, int height);
  /// @param veil_share  light that dust throws back ahead, as a share of reach_light: taken off first, and what it says
  ///                    of the light lost on the way is put back. 0 in clear air.
  [[nodiscard]] RangeProfile measure(const ImageView& frame, double veil_share = 0.0) noexcept;

 private:
  struct Sample {
    std::uint16_t u = 0, v = 0;
    float gain = 0.0f;  ///< undoes the fall-off
  };
  struct Cell {
    std::size_t first = 0, last = 0;  ///< of samples_
    double floor_share = 0.0;         ///< light of flat floor there, as a share of reach_light; in clear air
    double floor_range_m = 0.0;       ///< to that floor
    double veil_gain = 1.0;           ///< veil there over the veil in the middle of the frame
  };
  void place_samples(const Camera& camera);
  void place_cell(const Camera& camera, double azimuth_rad, double half_rad, int columns, double low_rad,
                  double high_rad, int rows);
  [[nodiscard]] float light_at(const ImageView& frame, const Sample& sample) const noexcept;
  [[nodiscard]] float middle_light(const ImageView& frame, const Cell& cell) noexcept;
  void measure_cells(const ImageView& frame) noexcept;
  [[nodiscard]] double extinction_1_m(double veil_share) const noexcept;
  [[nodiscard]] double reach_light(double veil_share, bool mind_walls) const noexcept;
  [[nodiscard]] double veil_share_of(const RangeProfile& profile) const noexcept;
  [[nodiscard]] double range_m(double light_share, double extinction_1_m) const noexcept;

  ColumnRangeConfig config_;
  double assumed_hfov_deg_;
  int grey16_depth_bits_;
  std::optional<Camera> camera_;
  int width_ = 0, height_ = 0;
  double azimuth_first_rad_ = 0.0, azimuth_step_rad_ = 0.0;
  std::array<float, 256> linear_{};
  std::vector<Sample> samples_;
  std::vector<Cell> cells_;    ///< kRangeBins of the band about the horizon, then those of the floor
  std::vector<float> lights_;  ///< of cells_, in the last frame
  std::vector<float> scratch_;
};

}  // namespace adit
