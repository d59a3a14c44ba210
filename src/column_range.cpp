#include "adit/column_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
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
constexpr double kWallCosine = 0.8;
// Share of reach_light that even clear air leaves in the darkest columns: walls at 12 m.
constexpr double kClearShare = 0.007;
// Veil over its value in the middle, 1 + this * tan^2 of the angle: towards the edge the line of sight passes the lamp
// beside the camera nearer (1 / cos), and what it throws back is turned by less than half a circle.
constexpr double kVeilRise = 1.5;
constexpr double kVeilMax = 0.4;    // thicker than any dust in which rock is seen at all
constexpr int kVeilSteps = 10;      // halvings: to 0.0004
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
      cells_.back().floor_range_m = config_.camera_height_m / sine;
    }
  std::size_t most = cells_.size();
  for (const Cell& cell : cells_) most = std::max(most, cell.last - cell.first);
  scratch_.resize(most);
  lights_.resize(cells_.size());
}

void ColumnRange::place_cell(const Camera& camera, double azimuth_rad, double half_rad, int columns, double low_rad,
                             double high_rad, int rows) {
  Cell cell;
  cell.first = samples_.size();
  const double ahead = std::cos(azimuth_rad) * std::cos(0.5 * (low_rad + high_rad));
  cell.veil_gain = 1.0 + kVeilRise * (1.0 / (ahead * ahead) - 1.0);
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
  const std::uint8_t* const pixel = frame.row(sample.v) + sample.u * frame.pixel_step();
  switch (frame.format) {
    case PixelFormat::kGrey8:
      return linear_[*pixel];
    case PixelFormat::kGrey16: {
      std::uint16_t value = 0;
      std::memcpy(&value, pixel, sizeof value);
      const int level = value >> (grey16_depth_bits_ - 8);
      return linear_[static_cast<std::size_t>(std::min(level, 255))];
    }
    default:  // green stands in the middle in either order, and has the most light and the least noise
      return linear_[pixel[frame.channel_step()]];
  }
}

float ColumnRange::middle_light(const ImageView& frame, const Cell& cell) noexcept {
  if (cell.last <= cell.first) return kLightMin;
  const std::size_t count = cell.last - cell.first;
  for (std::size_t i = 0; i < count; ++i)
    scratch_[i] = light_at(frame, samples_[cell.first + i]) * samples_[cell.first + i].gain;
  return std::max(ranked(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(count), 0.5), kLightMin);
}

void ColumnRange::measure_cells(const ImageView& frame) noexcept {
  for (std::size_t i = 0; i < cells_.size(); ++i) lights_[i] = middle_light(frame, cells_[i]);
}

/// As thick as the veil is, dust also takes light away.
double ColumnRange::extinction_1_m(double veil_share) const noexcept {
  return std::max(veil_share - kClearShare, 0.0) / config_.veil_per_extinction_m;
}

/// The scale of the ranges, from floor. Where a wall stands so near that a whole sector shows nothing but it, the wall
/// would pass for bright floor, and everything for further away than it is: there the scale is what puts that wall at
/// the near end of the floor that should be seen.
double ColumnRange::reach_light(double veil_share, bool mind_walls) const noexcept {
  constexpr std::size_t kAside = kFloorAside_deg.size(), kBelow = kFloorBelow_deg.size();
  const double extinction = extinction_1_m(veil_share);
  const auto light = [this](std::size_t below, std::size_t aside) {
    return static_cast<double>(lights_[kRangeBins + below * kAside + aside]);
  };
  std::array<double, kBelow * kAside> reach{};
  std::size_t count = 0;
  const auto ranked_reach = [&] {
    return count == 0 ? 0.0 : ranked(reach.begin(), reach.begin() + static_cast<std::ptrdiff_t>(count), kFloorRank);
  };
  const auto take = [&](double scale) {
    count = 0;
    for (std::size_t aside = 0; aside < kAside; ++aside) {
      const Cell* cell = &cells_[kRangeBins + aside];
      const double veil = veil_share * scale * cell->veil_gain;
      const double near = light(0, aside) - veil, middle = light(1, aside) - veil, far = light(2, aside) - veil;
      // Only where there is more rock than veil to be seen, or the veil's own fall would pass for a wall's.
      const bool is_wall = scale > 0.0 && near > veil && middle > kWallFallMin * near && far > kWallFallMin * middle;
      for (std::size_t below = 0; below < kBelow; ++below) {
        cell = &cells_[kRangeBins + below * kAside + aside];
        if (cell->last <= cell->first) continue;  // below the frame
        const double range_m = cell->floor_range_m, lost = std::exp(-2.0 * extinction * range_m);
        // Rock of a wall at the range of this floor is met nearly square.
        const double share = is_wall ? kWallCosine / (range_m * range_m) : cell->floor_share;
        reach[count++] = light(is_wall ? 0 : below, aside) / (share * lost + veil_share * cell->veil_gain);
        if (is_wall) break;
      }
    }
  };
  take(0.0);
  if (!mind_walls) return ranked_reach();
  take(ranked_reach());
  return ranked_reach();
}

/// The veil is what is left where nothing else is: its share depends on the scale, which depends on it.
double ColumnRange::veil_share_of(const RangeProfile& profile) const noexcept {
  std::array<float, kRangeBins> ahead{};
  for (std::size_t bin = 0; bin < kRangeBins; ++bin)
    ahead[bin] = profile.light[bin] / static_cast<float>(cells_[bin].veil_gain);
  const auto least = static_cast<double>(ranked(ahead.begin(), ahead.end(), kVeilRank));
  double low = 0.0, high = kVeilMax;
  for (int i = 0; i < kVeilSteps; ++i) {
    const double share = 0.5 * (low + high);
    (share * reach_light(share, false) < least ? low : high) = share;
  }
  return 0.5 * (low + high);
}

/// Newton's iteration for exp(-2 extinction r) / r^2 = light_share.
double ColumnRange::range_m(double light_share, double extinction_1_m) const noexcept {
  const double wanted = -0.5 * std::log(light_share);  // ln r + extinction r
  double r = std::exp(wanted);
  for (int i = 0; i < 4 && extinction_1_m > 0.0; ++i)
    r = std::max(r - (std::log(r) + extinction_1_m * r - wanted) / (1.0 / r + extinction_1_m), 0.1 * r);
  return std::clamp(r, config_.range_min_m, config_.range_max_m);
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
  measure_cells(frame);
  profile.azimuth_first_rad = azimuth_first_rad_;
  profile.azimuth_step_rad = azimuth_step_rad_;
  std::copy_n(lights_.begin(), kRangeBins, profile.light.begin());
  profile.reach_light = reach_light(veil_share, true);
  profile.valid = profile.reach_light > kReachLightMin;
  if (!profile.valid) return profile;
  profile.veil_share = veil_share_of(profile);
  const double extinction = extinction_1_m(veil_share);
  // Less light than this and a column is further than range_max_m: whatever it is, noise included.
  const double least = 1.0 / (config_.range_max_m * config_.range_max_m);
  for (std::size_t bin = 0; bin < kRangeBins; ++bin) {
    const double share =
        static_cast<double>(profile.light[bin]) / profile.reach_light - veil_share * cells_[bin].veil_gain;
    profile.range_m[bin] = static_cast<float>(
        range_m(std::max(share, least * std::exp(-2.0 * extinction * config_.range_max_m)), extinction));
  }
  return profile;
}

}  // namespace adit
