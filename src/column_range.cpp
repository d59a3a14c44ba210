#include "adit/column_range.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace adit {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// Samples of a bin of the band: enough for a median that a pipe, a prop or a lamp does not move.
constexpr int kBandRows = 24;
constexpr int kBandColumns = 3;
// The floor is looked at in cells below the horizon: near enough to be lit, far enough to be in the frame (a lens of
// 75 degrees sees 30 degrees down), and to either side, because one of them may show a wall instead.
constexpr std::array<double, 3> kFloorBelow_deg{26.0, 21.0, 17.0};
constexpr std::array<double, 5> kFloorAside_deg{-24.0, -12.0, 0.0, 12.0, 24.0};
constexpr double kFloorHalfHeight_deg = 2.0;
constexpr double kFloorHalfWidth_deg = 6.0;
constexpr double kFloorRank = 0.3;  // a wall in a cell looks like bright floor: the lower of the cells are floor
// From a cell to the next further away floor falls to 0.55, a wall rises to 1.1.
constexpr double kWallFallMin = 0.78;
constexpr double kVeilRank = 0.08;  // of the bins: those that look into the passage show the veil alone
constexpr double kCosineMin = 0.2;
constexpr float kLightMin = 1e-5f;  // below the first grey level: no division by zero
constexpr double kReachLightMin = 1e-3;

std::array<float, 256> linear_table(double gamma) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(std::pow(static_cast<double>(i) / 255.0, gamma));
  return table;
}

template <class Values>
auto ranked(Values first, Values last, double share) noexcept {
  const auto at = first + static_cast<std::ptrdiff_t>(share * static_cast<double>(last - first - 1) + 0.5);
  std::nth_element(first, at, last);
  return *at;
}

}  // namespace

ColumnRange::ColumnRange(const ColumnRangeConfig& config, double assumed_hfov_deg, int grey16_depth_bits)
    : config_(config),
      assumed_hfov_deg_(assumed_hfov_deg),
      grey16_depth_bits_(grey16_depth_bits),
      linear_(linear_table(config.display_gamma)) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

ColumnRange::ColumnRange(const ColumnRangeConfig& config, const Camera& camera, int grey16_depth_bits)
    : ColumnRange(config, 75.0, grey16_depth_bits) {
  camera_ = camera;
  reserve(camera.model().width, camera.model().height);
}

void ColumnRange::reserve(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = height_ = 0;
  place_samples(camera_ ? *camera_ : Camera(pinhole(width, height, assumed_hfov_deg_)));
  width_ = width;
  height_ = height;
}

void ColumnRange::place_samples(const Camera& camera) {
  samples_.clear();
  cells_.clear();
  const CameraModel& m = camera.model();
  const double left = camera.bearing_of({-0.5, m.principal_point_y_px}).azimuth_rad;
  const double right = camera.bearing_of({m.width - 0.5, m.principal_point_y_px}).azimuth_rad;
  azimuth_step_rad_ = (right - left) / kRangeBins;
  azimuth_first_rad_ = left + 0.5 * azimuth_step_rad_;
  for (int bin = 0; bin < kRangeBins; ++bin)
    place_cell(camera, azimuth_first_rad_ + azimuth_step_rad_ * bin, 0.5 * azimuth_step_rad_, kBandColumns,
               kDegree * config_.band_low_deg, kDegree * config_.band_high_deg, kBandRows);
  for (const double below_deg : kFloorBelow_deg)
    for (const double aside_deg : kFloorAside_deg) {
      place_cell(camera, kDegree * aside_deg, kDegree * kFloorHalfWidth_deg, 8,
                 -kDegree * (below_deg + kFloorHalfHeight_deg), -kDegree * (below_deg - kFloorHalfHeight_deg), 6);
      // Flat floor at the range h / sin(below), lit at this grazing angle: L ~ sin / r^2.
      const double sine = std::sin(kDegree * below_deg);
      cells_.back().floor_share = sine * sine * sine / (config_.camera_height_m * config_.camera_height_m);
    }
  std::size_t most = cells_.size();
  for (const Cell& cell : cells_) most = std::max(most, cell.last - cell.first);
  scratch_.resize(most);
}

void ColumnRange::place_cell(const Camera& camera, double azimuth_rad, double half_rad, int columns, double low_rad,
                             double high_rad, int rows) {
  Cell cell{samples_.size(), 0, 0.0};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Bearing bearing{azimuth_rad + half_rad * ((2 * column + 1.0) / columns - 1.0),
                            low_rad + (high_rad - low_rad) * (row + 0.5) / rows};
      const auto pixel = camera.pixel_of(bearing);
      if (!pixel) continue;
      const double u = std::round(pixel->u_px), v = std::round(pixel->v_px);
      if (!(u >= 0 && u < camera.model().width && v >= 0 && v < camera.model().height)) continue;
      const double cosine = std::max(std::cos(bearing.azimuth_rad) * std::cos(bearing.elevation_rad), kCosineMin);
      samples_.push_back({static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
                          static_cast<float>(std::pow(cosine, -config_.fall_off_exponent))});
    }
  cell.last = samples_.size();
  cells_.push_back(cell);
}

float ColumnRange::light_at(const ImageView& frame, const Sample& sample) const noexcept {
  const std::uint8_t* row = frame.row(sample.v);
  switch (frame.format) {
    case PixelFormat::kGrey8:
      return linear_[row[sample.u]];
    case PixelFormat::kGrey16: {
      const int level = reinterpret_cast<const std::uint16_t*>(row)[sample.u] >> (grey16_depth_bits_ - 8);
      return linear_[static_cast<std::size_t>(std::min(level, 255))];
    }
    default:  // green stands in the middle in either order, and has the most light and the least noise
      return linear_[row[sample.u * bytes_per_pixel(frame.format) + 1]];
  }
}

float ColumnRange::middle_light(const ImageView& frame, const Cell& cell) noexcept {
  if (cell.last <= cell.first) return kLightMin;
  const std::size_t count = cell.last - cell.first;
  for (std::size_t i = 0; i < count; ++i)
    scratch_[i] = light_at(frame, samples_[cell.first + i]) * samples_[cell.first + i].gain;
  return std::max(ranked(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(count), 0.5), kLightMin);
}

/// The scale of the ranges, from floor. Where a wall stands so near that a whole sector shows nothing but it, the wall
/// would pass for bright floor, and everything for further away than it is: there the scale is what puts that wall at
/// the near end of the floor that should be seen.
double ColumnRange::reach_light(const ImageView& frame, double veil_share) noexcept {
  std::array<std::array<double, kFloorAside_deg.size()>, kFloorBelow_deg.size()> light{};
  std::array<double, kFloorBelow_deg.size() * kFloorAside_deg.size()> reach{};
  std::size_t count = 0;
  const auto cell_of = [this](std::size_t below, std::size_t aside) -> const Cell& {
    return cells_[kRangeBins + below * kFloorAside_deg.size() + aside];
  };
  for (std::size_t below = 0; below < kFloorBelow_deg.size(); ++below)
    for (std::size_t aside = 0; aside < kFloorAside_deg.size(); ++aside) {
      const Cell& cell = cell_of(below, aside);
      if (cell.last <= cell.first) continue;  // below the frame
      light[below][aside] = static_cast<double>(middle_light(frame, cell));
      reach[count++] = light[below][aside] / (cell.floor_share + veil_share);
    }
  if (count == 0) return 0.0;
  const auto floor_rank = [&] {
    return ranked(reach.begin(), reach.begin() + static_cast<std::ptrdiff_t>(count), kFloorRank);
  };
  const double veil = veil_share * floor_rank();
  const double sine = std::sin(kDegree * kFloorBelow_deg[0]), cosine = std::cos(kDegree * kFloorBelow_deg[0]);
  const double near_m = config_.camera_height_m * cosine / sine;
  const double wall_share = cosine * cosine * cosine / (near_m * near_m);
  count = 0;
  for (std::size_t aside = 0; aside < kFloorAside_deg.size(); ++aside) {
    const double near = light[0][aside] - veil, middle = light[1][aside] - veil, far = light[2][aside] - veil;
    const bool is_wall = near > 0.0 && middle > kWallFallMin * near && far > kWallFallMin * middle;
    for (std::size_t below = 0; below < kFloorBelow_deg.size(); ++below) {
      const Cell& cell = cell_of(below, aside);
      if (cell.last <= cell.first) continue;
      reach[count++] =
          is_wall ? light[0][aside] / (wall_share + veil_share) : light[below][aside] / (cell.floor_share + veil_share);
    }
  }
  return floor_rank();
}

RangeProfile ColumnRange::measure(const ImageView& frame, double veil_share) noexcept {
  RangeProfile profile;
  if (!fault_of(frame).empty()) return profile;
  if (camera_ && (frame.width != width_ || frame.height != height_)) return profile;
  try {
    reserve(frame.width, frame.height);
  } catch (const std::exception&) {
    return profile;
  }
  profile.azimuth_first_rad = azimuth_first_rad_;
  profile.azimuth_step_rad = azimuth_step_rad_;
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) profile.light[bin] = middle_light(frame, cells_[bin]);
  profile.reach_light = reach_light(frame, veil_share);
  profile.valid = profile.reach_light > kReachLightMin;
  if (!profile.valid) return profile;
  const double veil = veil_share * profile.reach_light;
  // Less light than this and a column is further than range_max_m: whatever it is, noise included.
  const double least = profile.reach_light / (config_.range_max_m * config_.range_max_m);
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    const double light = std::max(static_cast<double>(profile.light[bin]) - veil, least);
    profile.range_m[bin] = static_cast<float>(std::max(std::sqrt(profile.reach_light / light), config_.range_min_m));
  }
  std::array<float, kRangeBins> sorted = profile.light;
  profile.veil_share = static_cast<double>(ranked(sorted.begin(), sorted.end(), kVeilRank)) / profile.reach_light;
  return profile;
}

}  // namespace adit
