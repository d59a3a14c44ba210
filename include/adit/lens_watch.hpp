// LensWatch: dirt on the lens, which a single frame cannot tell from an opening.
//
// Dirt turns with the camera, so it stands still in the frame while the vehicle turns; the world does not. A way on
// that is followed through a curve stands still as well, on the whole, but its rim does not: rock is ragged, and light
// falls gradually with range. So what is asked for is a place that is always dark with a rim, all round, that hardly
// ever is, while the vehicle turns both ways.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "adit/api.hpp"
#include "adit/camera.hpp"
#include "adit/column_range.hpp"
#include "adit/finder.hpp"
#include "adit/image.hpp"

namespace ADIT_API adit {

/// Every constant of the watch; unit, range and source of each field stand in visit_fields() (navigator_fields.hpp).
struct LensWatchConfig {
  double turn_step_rad = 0.035;
  double each_way_min_rad = 0.2;
  int looks_min = 10;
  double dark_fraction = 0.35;
  double rim_rad = 0.05;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const LensWatchConfig& config);

/// A spot of dirt, in the watch's cells; both ends belong to it.
struct DirtSpot {
  int left = 0, right = 0, top = 0, bottom = 0;
  int cells = 0;
  int light_frames = 0;  ///< in a row, in which light was seen there
};
inline constexpr std::size_t kDirtSpotsMax = 8;

/// Looks at a frame on a grid of 80 x 60 cells whenever the vehicle has turned by turn_step_rad. Of each cell it keeps
/// the share of the looks in which it was dark. Allocates nothing after the first frame.
class LensWatch {
 public:
  static constexpr int kColumns = 80, kRows = 60;

  /// Frames of any size, seen by an ideal pinhole of this horizontal field of view, deg.
  /// @throws std::invalid_argument naming the field, the value and the range.
  LensWatch(const LensWatchConfig& config, double assumed_hfov_deg, int grey16_depth_bits);
  /// Frames of the camera's size only.
  LensWatch(const LensWatchConfig& config, const Camera& camera, int grey16_depth_bits);

  /// The vehicle has turned, positive to the left.
  void turn(double yaw_rad) noexcept { turned_rad_ += yaw_rad; }
  /// A frame that shows rock.
  void look(const ImageView& frame) noexcept;
  void reset() noexcept;

  [[nodiscard]] std::span<const DirtSpot> spots() const noexcept { return {spots_.data(), spot_count_}; }
  /// Takes openings that are dirt out of the list and sets flags.dirty_lens; if none is left: kNoOpening.
  void take_out(OpenSpace& open_space) const noexcept;
  /// Columns that look at dirt get their ranges from those beside it.
  void take_out(RangeProfile& profile, double band_low_rad, double band_high_rad) const noexcept;

 private:
  static constexpr std::size_t kCells = static_cast<std::size_t>(kColumns) * kRows;
  template <class Value>
  using Cells = std::array<Value, kCells>;

  bool prepare(const ImageView& frame) noexcept;
  [[nodiscard]] int level_at(const ImageView& frame, int u, int v) const noexcept;
  bool mark_dark(const ImageView& frame) noexcept;
  void note_look() noexcept;
  void find_spots() noexcept;
  std::size_t grow(std::size_t first, std::uint8_t mark, DirtSpot& spot) noexcept;
  [[nodiscard]] bool has_still_rim(std::size_t count) noexcept;
  void name(std::size_t count, const DirtSpot& spot) noexcept;
  void forget_light() noexcept;
  [[nodiscard]] bool is_dirt(const Opening& opening) const noexcept;

  LensWatchConfig config_;
  double assumed_hfov_deg_;
  int grey16_depth_bits_;
  std::optional<Camera> camera_;
  int width_ = 0, height_ = 0;
  std::array<double, kColumns> azimuth_rad_{};
  std::array<double, kRows> elevation_rad_{};
  int rim_cells_ = 3;

  double turned_rad_ = 0.0;                  ///< since the beginning
  double last_look_rad_ = 0.0;               ///< turned_rad_ at the last look
  double low_rad_ = 0.0, high_rad_ = 0.0;    ///< headings of the looks that count
  double left_rad_ = 0.0, right_rad_ = 0.0;  ///< turned between them, each way
  int looks_ = 0;
  Cells<float> share_{};          ///< of the looks in which a cell was dark
  Cells<std::uint8_t> dark_{};    ///< in this frame
  Cells<std::uint8_t> seen_{};    ///< scratch: whose place a cell is
  Cells<std::uint8_t> dirt_{};    ///< 1 + the spot that a cell belongs to
  Cells<std::uint8_t> rival_{};   ///< looks in a row in which a cell belonged to a place with a still rim
  Cells<std::uint16_t> level_{};  ///< scratch
  Cells<std::uint16_t> queue_{};  ///< scratch
  std::array<DirtSpot, kDirtSpotsMax> spots_{};
  std::size_t spot_count_ = 0;
};

}  // namespace adit
