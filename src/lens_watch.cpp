#include "adit/lens_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "best_opening.hpp"

namespace adit {
namespace {

constexpr int kPerSide = 2;       // pixels along a cell's side that are looked at
constexpr int kContrastMin = 16;  // levels from darkest to median, or there is no rock to be dark beside
constexpr double kMemory = 30.0;  // looks
constexpr float kAlways = 0.93f;  // share of the looks in which a place is dark: all but two of the memory
constexpr float kOften = 0.5f;    // dirt over a dark part of the world is not always the darker one
// Of the rim's cells. On twelve courses the rims of ways on had 0.62 and more somewhere, those of a curve of 40 m
// radius without any relief 0.5; dirt 0.4 and less.
constexpr double kRimMost = 0.45, kRimMean = 0.2;
constexpr int kCellsMin = 8;       // smaller dirt is not told as an opening
constexpr double kCellsMax = 0.3;  // of the frame: what is larger has no rim to judge it by
constexpr std::uint8_t kRivalLooks = 3;
constexpr int kLightFrames = 10;    // light in so many frames in a row: wiped off
constexpr double kDirtShare = 0.4;  // of an opening's box; a disc fills 0.79 of its own
constexpr double kBandShare = 0.4;  // of the ranges' band: less does not move its median

const LensWatchConfig& checked(const LensWatchConfig& config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  return config;
}

constexpr std::size_t cell_at(int u, int v) noexcept {
  return static_cast<std::size_t>(v) * LensWatch::kColumns + static_cast<std::size_t>(u);
}

}  // namespace

LensWatch::LensWatch(const LensWatchConfig& config, double assumed_hfov_deg, int grey16_depth_bits)
    : config_(checked(config)), assumed_hfov_deg_(assumed_hfov_deg), grey16_depth_bits_(grey16_depth_bits) {}

LensWatch::LensWatch(const LensWatchConfig& config, const Camera& camera, int grey16_depth_bits)
    : LensWatch(config, 75.0, grey16_depth_bits) {
  camera_ = camera;
}

void LensWatch::reset() noexcept {
  looks_ = 0;
  left_rad_ = right_rad_ = 0.0;
  spot_count_ = 0;
  share_.fill(0.0f);
  rival_.fill(0);
  dirt_.fill(0);
}

/// Directions of the cells, for frames of this size. @return false if there is no camera for them.
bool LensWatch::prepare(const ImageView& frame) noexcept {
  if (frame.width == width_ && frame.height == height_) return true;
  try {
    const Camera camera = camera_ ? *camera_ : Camera(pinhole(frame.width, frame.height, assumed_hfov_deg_));
    const double middle_u_px = 0.5 * (frame.width - 1), middle_v_px = 0.5 * (frame.height - 1);
    for (std::size_t i = 0; i < kColumns; ++i)
      azimuth_rad_[i] =
          camera.bearing_of({(static_cast<double>(i) + 0.5) * frame.width / kColumns - 0.5, middle_v_px}).azimuth_rad;
    for (std::size_t i = 0; i < kRows; ++i)
      elevation_rad_[i] =
          camera.bearing_of({middle_u_px, (static_cast<double>(i) + 0.5) * frame.height / kRows - 0.5}).elevation_rad;
  } catch (const std::exception&) {
    return false;
  }
  const double cell_rad = azimuth_rad_[kColumns / 2] - azimuth_rad_[kColumns / 2 - 1];
  rim_cells_ = std::clamp(static_cast<int>(std::lround(config_.rim_rad / std::max(cell_rad, 1e-6))), 2, 10);
  reset();
  width_ = frame.width;
  height_ = frame.height;
  return true;
}

/// Green, or grey, 0 to 255.
int LensWatch::level_at(const ImageView& frame, int u, int v) const noexcept {
  const std::uint8_t* at = frame.row(v) + u * frame.pixel_step();
  if (frame.format == PixelFormat::kGrey8) return *at;
  if (frame.format != PixelFormat::kGrey16) return at[frame.channel_step()];
  std::uint16_t value = 0;
  std::memcpy(&value, at, sizeof value);
  return std::min(value >> (grey16_depth_bits_ - 8), 255);
}

/// Which cells are dark. @return false for a frame that shows no rock to judge by.
bool LensWatch::mark_dark(const ImageView& frame) noexcept {
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      int sum = 0;
      for (int b = 0; b < kPerSide; ++b)
        for (int a = 0; a < kPerSide; ++a)
          sum += level_at(frame, (2 * (kPerSide * i + a) + 1) * width_ / (2 * kPerSide * kColumns),
                          (2 * (kPerSide * j + b) + 1) * height_ / (2 * kPerSide * kRows));
      level_[cell_at(i, j)] = static_cast<std::uint16_t>(sum);
    }
  constexpr int kParts = kPerSide * kPerSide * 9;  // of a level, after the mean of 3 x 3 cells
  const auto mean_at = [this](int i, int j) {
    int sum = 0;
    for (int b = std::max(j - 1, 0); b <= j + 1; ++b)
      for (int a = std::max(i - 1, 0); a <= i + 1; ++a)
        sum += level_[cell_at(std::min(a, kColumns - 1), std::min(b, kRows - 1))];
    const int missing = (i == 0 ? 3 : 0) + (j == 0 ? 3 : 0) - (i == 0 && j == 0 ? 1 : 0);
    return sum * 9 / (9 - missing);
  };
  std::array<int, 256> count{};
  int darkest = 256 * kParts;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      const int mean = mean_at(i, j);
      queue_[cell_at(i, j)] = static_cast<std::uint16_t>(mean);  // up to 9180
      darkest = std::min(darkest, mean);
      ++count[static_cast<std::size_t>(mean / kParts)];
    }
  int median = 0;
  for (int below = count[0]; below < static_cast<int>(kCells) / 2; below += count[static_cast<std::size_t>(median)])
    ++median;
  if (median * kParts - darkest < kContrastMin * kParts) return false;
  const double limit = darkest + config_.dark_fraction * (median * kParts - darkest);
  for (std::size_t i = 0; i < kCells; ++i) dark_[i] = queue_[i] < limit ? 1 : 0;
  return true;
}

void LensWatch::look(const ImageView& frame) noexcept {
  if (!prepare(frame)) return;
  const bool is_due = looks_ == 0 || std::abs(turned_rad_ - last_look_rad_) >= config_.turn_step_rad;
  if (!is_due && spot_count_ == 0) return;
  if (!mark_dark(frame)) return;
  forget_light();
  if (!is_due) return;
  note_look();
  // Both ways: through a long curve to one side, steered well, a way on stands still by itself.
  const double turned_rad = std::min({high_rad_ - low_rad_, left_rad_, right_rad_});
  if (looks_ >= config_.looks_min && turned_rad >= config_.each_way_min_rad) find_spots();
}

void LensWatch::note_look() noexcept {
  const double pull = 1.0 / kMemory;  // the turns that count are those of the looks that count
  low_rad_ = looks_ == 0 ? turned_rad_ : std::min(turned_rad_, low_rad_ + pull * (turned_rad_ - low_rad_));
  high_rad_ = looks_ == 0 ? turned_rad_ : std::max(turned_rad_, high_rad_ + pull * (turned_rad_ - high_rad_));
  const double step_rad = looks_ == 0 ? 0.0 : turned_rad_ - last_look_rad_;
  left_rad_ += std::max(step_rad, 0.0) - pull * left_rad_;
  right_rad_ += std::max(-step_rad, 0.0) - pull * right_rad_;
  last_look_rad_ = turned_rad_;
  ++looks_;
  const auto weight = static_cast<float>(std::max(1.0 / looks_, 1.0 / kMemory));
  for (std::size_t i = 0; i < kCells; ++i) share_[i] += weight * (static_cast<float>(dark_[i]) - share_[i]);
}

/// The cells about `first` that are always dark, in queue_. @return how many; those at the frame's edge are none of
/// ours: the corners outside a lamp's beam stand still, too.
std::size_t LensWatch::grow(std::size_t first, std::uint8_t mark, DirtSpot& spot) noexcept {
  std::size_t count = 0;
  const auto add = [&](std::size_t cell) {
    if (seen_[cell] != 0 || share_[cell] < kAlways || dirt_[cell] != 0) return;
    seen_[cell] = mark;
    queue_[count++] = static_cast<std::uint16_t>(cell);
  };
  spot = {kColumns, -1, kRows, -1, 0, 0};
  add(first);
  for (std::size_t at = 0; at < count; ++at) {
    const std::size_t cell = queue_[at];
    const int u = static_cast<int>(cell % kColumns), v = static_cast<int>(cell / kColumns);
    spot.left = std::min(spot.left, u);
    spot.right = std::max(spot.right, u);
    spot.top = std::min(spot.top, v);
    spot.bottom = std::max(spot.bottom, v);
    if (u > 0) add(cell - 1);
    if (u + 1 < kColumns) add(cell + 1);
    if (v > 0) add(cell - kColumns);
    if (v + 1 < kRows) add(cell + kColumns);
  }
  spot.cells = static_cast<int>(count);
  return count;
}

/// Is the ring about the cells in queue_ hardly ever dark?
bool LensWatch::has_still_rim(std::size_t count) noexcept {
  Cells<std::uint8_t>& near = dark_;  // not needed any more in this frame
  near.fill(0);
  const int inner = rim_cells_ * rim_cells_, outer = (rim_cells_ + 1) * (rim_cells_ + 1);
  for (std::size_t at = 0; at < count; ++at) {
    const int u = queue_[at] % kColumns, v = queue_[at] / kColumns;
    for (int b = std::max(v - rim_cells_ - 1, 0); b <= std::min(v + rim_cells_ + 1, kRows - 1); ++b)
      for (int a = std::max(u - rim_cells_ - 1, 0); a <= std::min(u + rim_cells_ + 1, kColumns - 1); ++a) {
        const int off = (a - u) * (a - u) + (b - v) * (b - v);
        if (off <= inner)
          near[cell_at(a, b)] = 2;
        else if (off <= outer && near[cell_at(a, b)] == 0)
          near[cell_at(a, b)] = 1;
      }
  }
  double sum = 0.0, most = 0.0;
  int cells = 0;
  for (std::size_t i = 0; i < kCells; ++i) {
    if (near[i] != 1) continue;
    sum += static_cast<double>(share_[i]);
    most = std::max(most, static_cast<double>(share_[i]));
    ++cells;
  }
  return cells > 0 && most <= kRimMost && sum <= kRimMean * cells;
}

void LensWatch::find_spots() noexcept {
  seen_.fill(0);
  for (std::size_t first = 0; first < kCells; ++first) {
    if (seen_[first] != 0 || share_[first] < kAlways || dirt_[first] != 0) continue;
    DirtSpot spot;
    const std::size_t count = grow(first, 1, spot);
    const bool is_cut = spot.left == 0 || spot.top == 0 || spot.right + 1 == kColumns || spot.bottom + 1 == kRows;
    const bool fits = spot.cells >= kCellsMin && spot.cells <= kCellsMax * static_cast<double>(kCells);
    if (is_cut || !fits || !has_still_rim(count)) {
      for (std::size_t at = 0; at < count; ++at) rival_[queue_[at]] = 0;
      continue;
    }
    std::uint8_t looks = 0;
    for (std::size_t at = 0; at < count; ++at) looks = std::max(looks, ++rival_[queue_[at]]);
    if (looks >= kRivalLooks) name(count, spot);
  }
}

/// With the cells about it: its soft edge.
void LensWatch::name(std::size_t count, const DirtSpot& spot) noexcept {
  for (std::size_t at = 0; at < count; ++at) rival_[queue_[at]] = 0;
  if (spot_count_ == kDirtSpotsMax) return;
  spots_[spot_count_++] = spot;
  constexpr int kEdge = 2;
  for (std::size_t at = 0; at < count; ++at) {
    const int u = queue_[at] % kColumns, v = queue_[at] / kColumns;
    for (int b = std::max(v - kEdge, 0); b <= std::min(v + kEdge, kRows - 1); ++b)
      for (int a = std::max(u - kEdge, 0); a <= std::min(u + kEdge, kColumns - 1); ++a)
        if ((a - u) * (a - u) + (b - v) * (b - v) <= kEdge * kEdge + 1)
          dirt_[cell_at(a, b)] = static_cast<std::uint8_t>(spot_count_);
  }
}

void LensWatch::forget_light() noexcept {
  std::array<int, kDirtSpotsMax + 1> dark{};
  if (spot_count_ == 0) return;
  for (std::size_t i = 0; i < kCells; ++i) dark[dirt_[i]] += dirt_[i] != 0 ? dark_[i] : 0;
  bool is_wiped = false;
  for (std::size_t k = 0; k < spot_count_; ++k) {
    DirtSpot& spot = spots_[k];
    const bool is_light = static_cast<float>(dark[k + 1]) < kOften * static_cast<float>(spot.cells);
    spot.light_frames = is_light ? spot.light_frames + 1 : 0;
    is_wiped = is_wiped || spot.light_frames >= kLightFrames;
  }
  if (is_wiped) reset();  // what is still there is soon found again
}

bool LensWatch::is_dirt(const Opening& opening) const noexcept {
  const auto cell_of = [](double px, int side_px, int cells) {
    return std::clamp(static_cast<int>((px + 0.5) * cells / side_px), 0, cells - 1);
  };
  const int left = cell_of(opening.top_left_px.u_px, width_, kColumns);
  const int right = cell_of(opening.bottom_right_px.u_px, width_, kColumns);
  const int top = cell_of(opening.top_left_px.v_px, height_, kRows);
  const int bottom = cell_of(opening.bottom_right_px.v_px, height_, kRows);
  int cells = 0, dirty = 0;
  for (int v = top; v <= bottom; ++v)
    for (int u = left; u <= right; ++u) {
      ++cells;
      dirty += dirt_[cell_at(u, v)] != 0 ? 1 : 0;
    }
  return dirty >= kDirtShare * cells;
}

void LensWatch::take_out(OpenSpace& open_space) const noexcept {
  if (spot_count_ == 0) return;
  open_space.flags.dirty_lens = true;
  // In dust the opening is the middle of the air, and no place of its own.
  if (!open_space.found() || open_space.rule == Rule::kVeil) return;
  const auto first = open_space.openings.begin();
  const auto last = std::remove_if(first, first + open_space.opening_count,
                                   [this](const Opening& opening) { return is_dirt(opening); });
  const auto left = static_cast<int>(last - first);
  if (left == open_space.opening_count) return;
  std::fill(last, first + open_space.opening_count, Opening{});
  open_space.opening_count = left;
  if (left > 0) {
    note_best(open_space.rule == Rule::kFlash ? Rule::kFlash : rule_by_rim(open_space.openings[0]), open_space);
    return;
  }
  note_best(Rule::kNone, open_space);
  open_space.status = Status::kNoOpening;
}

void LensWatch::take_out(RangeProfile& profile, double band_low_rad, double band_high_rad) const noexcept {
  for (const DirtSpot& spot : spots()) {
    const double top_rad = std::min(elevation_rad_[static_cast<std::size_t>(std::max(spot.top - 1, 0))], band_high_rad);
    const double bottom_rad =
        std::max(elevation_rad_[static_cast<std::size_t>(std::min(spot.bottom + 1, kRows - 1))], band_low_rad);
    if (top_rad - bottom_rad < kBandShare * (band_high_rad - band_low_rad)) continue;
    const auto bin_of = [&](int column, int aside) {
      const double azimuth_rad = azimuth_rad_[static_cast<std::size_t>(std::clamp(column, 0, kColumns - 1))];
      const double bin = (azimuth_rad - profile.azimuth_first_rad) / profile.azimuth_step_rad;
      return std::clamp(static_cast<int>(std::lround(bin)) + aside, 0, static_cast<int>(kRangeBins) - 1);
    };
    const int from = bin_of(spot.left - 1, -1), to = bin_of(spot.right + 1, 1);
    const float before = profile.range_m[static_cast<std::size_t>(from)];
    const float after = profile.range_m[static_cast<std::size_t>(to)];
    for (int bin = from + 1; bin < to; ++bin) {
      const auto share = static_cast<float>(bin - from) / static_cast<float>(to - from);
      profile.range_m[static_cast<std::size_t>(bin)] = before + share * (after - before);
    }
  }
}

}  // namespace adit
