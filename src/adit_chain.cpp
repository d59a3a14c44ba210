#include "adit_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "best_opening.hpp"
#include "enclosure.hpp"
#include "opening_extent.hpp"
#include "way_odds.hpp"

namespace adit {
namespace {

/// A rise beyond this adds nothing: four stops are a range four times as long, which is as open as open gets, and a
/// foreign lamp on the rim is not to make its surroundings the best place.
constexpr int kRiseMax = 4 * kStop;
/// But where in an open place it is deepest, the whole rise tells. Twelve stops are more than 8 bits hold in the dark.
constexpr int kDepthMax = 12 * kStop;

/// Weight of an elevation, 0 to 256.
std::int16_t weight_of(double elevation_rad, const FinderConfig& config) {
  const double spread_rad = config.horizon_spread_deg * std::numbers::pi / 180.0;
  const double bell = std::exp(-0.5 * elevation_rad * elevation_rad / (spread_rad * spread_rad));
  return static_cast<std::int16_t>(std::lround(256.0 * (config.horizon_floor + (1.0 - config.horizon_floor) * bell)));
}

/// The share of openings, sure not to be a wall, that are the right ones: some frames show two, or a recess that is
/// as deep.
constexpr double kConfidenceMax = 0.96;
/// Less in dust: of 319 rendered frames of eleven sets 289 were hits, and no real one is among them.
constexpr double kConfidenceInDust = 0.90;
/// Rock that exceeds the veil by less than this in nine tenths of the frame is not seen: it is what the tone curve's
/// rounding to whole levels makes of a smooth lobe; and what noise makes of it, for each part of its share in a cell: a
/// block has a quarter of that, times 2.2 in light, and its brightest tenth lies three deviations above the envelope.
constexpr double kNoRock = 0.025, kNoRockOfNoise = 3.0 * 2.2 / 4.0;
/// What of the veil the lobe does not fit, and from where on rock is plainly seen: in rendered dust of 0.5 1/m, which
/// hides all beyond 2 m, the brightest tenth exceeds the fit by 0.07 to 0.11, and a hit is luck.
constexpr double kMisfit = 0.04, kRockPlain = 0.14, kSightLeast = 0.4;
/// What noise alone, amplified, puts the brightest tenth of a black frame above its median; rock at the edge of sight
/// puts it a third of a stop above.
constexpr double kNoiseAlone_stops = 0.3;
/// From this share of the light on the veil is taken off before the search. Less of it hides no rim, and what it adds
/// to the dark places is less than the walls' shading.
constexpr double kVeilOffMin = 0.6;

/// What is at the end of the range is as smooth as a veil, whatever it is: from this share of the frame on it may be a
/// near wall before the exposure has come down to it. Rendered dust exposed for its own light has less than a
/// hundredth.
constexpr double kVeilSaturatedMax = 0.1;

double confidence_of(double odds, double most) noexcept { return most / (1.0 + std::exp(-odds)); }

/// How much of what can be seen in dust is seen, kSightLeast to 1.
double sight_of(const VeilSight& veil) noexcept {
  return std::clamp((veil.rock_high - kMisfit) / (kRockPlain - kMisfit), kSightLeast, 1.0);
}

void aim(Pixel centroid_px, const Camera& camera, Opening& to) noexcept {
  to.centroid_px = centroid_px;
  to.point = camera.normalised_of(centroid_px);
  to.bearing = camera.bearing_of(centroid_px);
}

/// a * b / 256, downwards. Both below 4096; unsigned and in sixteen bits, so that it becomes vector code.
std::uint16_t product_256th(std::uint16_t a, std::uint16_t b) noexcept {
  const auto wide = static_cast<std::uint32_t>(static_cast<std::uint16_t>(a << 4)) * static_cast<std::uint16_t>(b << 4);
  return static_cast<std::uint16_t>(wide >> 16);
}

template <class Value, class Of>
std::vector<Value> enlarged(const CellGrid& grid, int width, int height, Of&& of) {
  std::vector<Value> out(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int cell_v = 0; cell_v < grid.height(); ++cell_v) {
    for (int cell_u = 0; cell_u < grid.width(); ++cell_u) {
      const Value value = of(cell_u, cell_v);
      for (int v = grid.first_v(cell_v); v < grid.first_v(cell_v + 1); ++v) {
        Value* row = out.data() + static_cast<std::ptrdiff_t>(v) * width;
        std::fill(row + grid.first_u(cell_u), row + grid.first_u(cell_u + 1), value);
      }
    }
  }
  return out;
}

}  // namespace

AditChain::AditChain(const FinderConfig& config, const Camera& camera, int frame_width_px, int frame_height_px)
    : frame_width_px_(frame_width_px),
      frame_height_px_(frame_height_px),
      grid_(frame_width_px, frame_height_px),
      rows_(frame_width_px),
      filter_(grid_.width(), grid_.height()),
      noise_floor_(config.light_gamma),
      enclosing_(grid_.width(), grid_.height()),
      search_(grid_.width(), grid_.height()),
      veil_fit_(grid_, camera, config),
      cusp_(grid_, camera, veil_fit_.block(), config.horizon_spread_deg),
      no_cusp_(static_cast<std::size_t>(grid_.width()), std::int16_t{256}),
      lobe_on_cells_(grid_, camera),
      lamp_(grid_.width(), grid_.height()),
      other_level_(lamp_),
      level_(lamp_),
      cleaned_(level_),
      light_(level_),
      map_(level_),
      depth_(level_) {
  make_light_table(config.light_gamma, config.noise_level, table_);
  elevation_weight_.reserve(static_cast<std::size_t>(grid_.height()));
  const double middle_u_px = 0.5 * (frame_width_px - 1);
  for (int v = 0; v < grid_.height(); ++v) {
    elevation_weight_.push_back(weight_of(camera.bearing_of({middle_u_px, grid_.v_px(v)}).elevation_rad, config));
  }
}

void AditChain::take(const ImageView& frame, const FinderConfig& config) noexcept {
  reduce(frame, config.grey16_depth_bits, grid_, rows_, level_);
}

void AditChain::find(const FinderConfig& config, const Camera& camera, OpenSpace& out) noexcept {
  cleaned_.values = level_.values;
  noise_share_ = NoiseFloor::noise_share(level_);
  const double floor_share = NoiseFloor::floor_share(noise_share_);
  if (floor_share > 0.0) blur(cleaned_, filter_);  // before least and most are picked, which would be noise
  clean();
  const LevelRange range = note_levels(out);
  if (floor_share > 0.0) noise_floor_.take_off(floor_share, range.least, range.most, cleaned_);
  const VeilSight veil = veil_fit_.judge(cleaned_);
  const double saturated_share = note_flags(config, veil, out);
  const bool veil_off = out.veil_fraction >= kVeilOffMin;
  // In dust neither the search nor the odds look at it.
  if (!(out.flags.dust && veil_off)) cusp_.judge(veil_fit_.log_light());
  if (veil_off) {
    veil_fit_.take_off(cleaned_, lobe_on_cells_, light_);
  } else {
    look_up(cleaned_, table_, light_);
    if (lamp_known_) brighten_outside_beam();
  }
  search(!out.flags.dust);
  out.status = judge_levels(config, out);
  light_usable_ = !out.flags.dust && out.status == Status::kFound;
  if (out.status != Status::kFound) return;
  if (out.flags.too_dark && veil.above_stops < kNoiseAlone_stops) {
    out.status = Status::kTooDark;
    return;
  }
  if (out.flags.dust && saturated_share > kVeilSaturatedMax) {
    out.status = Status::kTooBright;
    return;
  }
  if (hides_all_rock(veil, out.flags)) {
    out.status = veil.lobe_in_frame ? Status::kDust : Status::kBlockedLens;
    return;
  }
  note_openings(config, camera, veil, veil_off, out);
}

bool AditChain::hides_all_rock(const VeilSight& veil, const SightFlags& flags) const noexcept {
  return flags.dust && veil.rock_high < kNoRock + kNoRockOfNoise * noise_share_;
}

void AditChain::clean() noexcept {
  erode_3(cleaned_, filter_);  // specks of light smaller than three cells go: reflectors, lamps far away
  dilate_3(cleaned_, filter_);
  dilate_5(cleaned_, filter_);  // dark lines thinner than five cells go: cables, pipes, cracks
  erode_5(cleaned_, filter_);
  blur(cleaned_, filter_);
}

void AditChain::search(bool by_cusp) noexcept {
  // Where noise hides the rest, near rock at the rim may be all that is seen.
  enclosure_of(light_, NoiseFloor::floor_share(noise_share_) > 0.0, enclosing_, map_);
  weigh(by_cusp);
  blur(depth_, filter_);
  blur(map_, filter_);  // twice: a standard deviation of 1.4 cells, so that a peak is of a place and not of noise
  blur(map_, filter_);
  candidates_ = search_openings(map_, depth_, search_);
  if (by_cusp) rank_by_cusp();
}

void AditChain::rank_by_cusp() noexcept {
  for (int i = 0; i < candidates_.count; ++i) {
    Candidate& of = candidates_.list[static_cast<std::size_t>(i)];
    const std::vector<std::int16_t>& weights = cusp_.weights_of_row(static_cast<int>(std::lround(of.v)));
    of.rank = of.strength * weights[static_cast<std::size_t>(std::lround(of.u))];
  }
  order_by_rank(candidates_);
}

Status AditChain::judge_levels(const FinderConfig& config, const OpenSpace& out) const noexcept {
  if (out.atmospheric_light < config.too_dark_light_max) return Status::kTooDark;
  if (out.darkest_level >= config.too_bright_level_min) return Status::kTooBright;
  if (out.brightest_level - out.darkest_level < config.contrast_levels_min) return Status::kNoContrast;
  return Status::kFound;
}

/// A dark place shows at least the veil before it, so it bounds how much veil there can be; noise and the lobe's misfit
/// may take a quarter off.
constexpr double kUndercutNoise = 1.3;
/// Cells at the end of the range, of which a lamp in view has few; the wall in the vehicle's own light may have many.
constexpr int kSaturated = 250 * kLevelParts;
constexpr double kTooBrightShare = 0.25;
/// Below this brightest level a camera at full gain shows as much noise as rock.
constexpr double kFaint_level = 24.0;

/// The share of the frame at the end of the range.
double AditChain::note_flags(const FinderConfig& config, const VeilSight& veil, OpenSpace& out) const noexcept {
  out.veil_fraction = veil.fraction * std::min(1.0, kUndercutNoise * veil.undercut);
  out.flags.dust = out.veil_fraction >= config.dust_veil_min;
  out.flags.blocked_lens = hides_all_rock(veil, out.flags) && !veil.lobe_in_frame;
  out.flags.too_dark = out.atmospheric_light < kFaint_level;
  int saturated = 0;
  bool steep = false;
  constexpr int kAway = 6;  // cells: a lamp's halo has fallen to less than half there, a lit wall's light has not
  for (int v = 0; v < level_.height; ++v) {
    const std::int16_t* row = level_.row(v);
    if (*std::max_element(row, row + level_.width) < kSaturated) continue;
    for (int u = 0; u < level_.width; ++u) {
      if (row[u] < kSaturated) continue;
      ++saturated;
      const int left = row[std::max(0, u - kAway)], right = row[std::min(level_.width - 1, u + kAway)];
      const int above = level_.row(std::max(0, v - kAway))[u];
      const int below = level_.row(std::min(level_.height - 1, v + kAway))[u];
      steep = steep || std::max({left, right, above, below}) < kSaturated / 2;
    }
  }
  out.flags.glare = steep;
  const double share = saturated / static_cast<double>(level_.values.size());
  out.flags.too_bright = share > kTooBrightShare;
  return share;
}

/// In dust rims are soft, and where rock is near they are steepest: the middle of the air that is seen says more.
void AditChain::note_way_through_dust(const Camera& camera, const VeilSight& veil, Opening& to) noexcept {
  const AirPlace air = veil_fit_.air_place(veil);
  aim({grid_.u_px(air.u), grid_.v_px(air.v)}, camera, to);
  to.top_left_px = {grid_.u_px(air.u - air.half_width), grid_.v_px(air.v - air.half_height)};
  to.bottom_right_px = {grid_.u_px(air.u + air.half_width), grid_.v_px(air.v + air.half_height)};
  to.area_fraction = (to.bottom_right_px.u_px - to.top_left_px.u_px + 1.0) *
                     (to.bottom_right_px.v_px - to.top_left_px.v_px + 1.0) /
                     (static_cast<double>(frame_width_px_) * frame_height_px_);
  to.score = 0.05;
  to.contrast = veil.rock_high / (1.0 + veil.rock_high);
  note_extent(camera, to);
}

void AditChain::weigh(bool by_cusp) noexcept {
  const auto cells = static_cast<std::size_t>(map_.width);
  for (int v = 0; v < map_.height; ++v) {
    std::int16_t* __restrict const row = map_.row(v);
    std::int16_t* __restrict const deep = depth_.row(v);
    const auto elevation = static_cast<std::uint16_t>(elevation_weight_[static_cast<std::size_t>(v)]);
    const std::int16_t* __restrict const cusp = by_cusp ? cusp_.weights_of_row(v).data() : no_cusp_.data();
    for (std::size_t u = 0; u < cells; ++u) {
      const auto rise = static_cast<std::uint16_t>(row[u]);
      const std::uint16_t weight = product_256th(elevation, static_cast<std::uint16_t>(cusp[u]));
      deep[u] = static_cast<std::int16_t>(product_256th(std::min<std::uint16_t>(rise, kDepthMax), weight));
      row[u] = static_cast<std::int16_t>(product_256th(std::min<std::uint16_t>(rise, kRiseMax), elevation));
    }
  }
}

AditChain::LevelRange AditChain::note_levels(OpenSpace& out) const noexcept {
  std::int16_t least = kLevelPartsMax, most = 0;  // by hand: std::minmax_element does not become vector code
  for (const std::int16_t level : cleaned_.values) {
    least = level < least ? level : least;
    most = level > most ? level : most;
  }
  out.darkest_level = least / kLevelParts;
  out.brightest_level = most / kLevelParts;
  out.threshold_level = out.darkest_level;
  out.atmospheric_light = static_cast<double>(most) / kLevelParts;
  return {least, most};
}

void AditChain::note_openings(const FinderConfig& config, const Camera& camera, const VeilSight& veil, bool veil_off,
                              OpenSpace& out) noexcept {
  const int cells = static_cast<int>(level_.values.size());
  for (int i = 0; i < candidates_.count; ++i) {
    const Candidate& from = candidates_.list[static_cast<std::size_t>(i)];
    const bool is_first = i == 0;
    // Another way has a cusp of its own; the frame's largest is the first one's.
    const double cusp = is_first ? cusp_.most() : cusp_.share_at(from.u, from.v);
    const double odds = way_odds(from, cells, veil, cusp, veil_off);
    if (odds < config.way_odds_min) {
      if (is_first) break;  // where the first is none, the weaker ones are not asked
      continue;
    }
    Opening& to = out.openings[static_cast<std::size_t>(out.opening_count++)];
    to.confidence = confidence_of(odds, out.flags.dust ? kConfidenceInDust * sight_of(veil) : kConfidenceMax);
    if (out.flags.dust) {  // the air has one middle, whatever the places of the search
      note_way_through_dust(camera, veil, to);
      break;
    }
    note_opening(from, camera, to);
  }
  if (out.opening_count == 0) {
    out.status = Status::kNoOpening;
    return;
  }
  note_best(out.flags.dust ? Rule::kVeil : rule_by_rim(out.openings[0]), out);
}

void AditChain::note_opening(const Candidate& from, const Camera& camera, Opening& to) const noexcept {
  aim({grid_.u_px(from.u), grid_.v_px(from.middle_v)}, camera, to);
  to.area_fraction = static_cast<double>(from.cells) / (static_cast<double>(grid_.width()) * grid_.height());
  to.score = std::min(1.0, from.strength / 4.0);
  to.contrast = 1.0 - std::exp2(-static_cast<double>(from.peak) / kStop);
  to.top_left_px = {static_cast<double>(grid_.first_u(from.left)), static_cast<double>(grid_.first_v(from.top))};
  to.bottom_right_px = {grid_.first_u(from.right + 1) - 1.0, grid_.first_v(from.bottom + 1) - 1.0};
  // No place reaches into the rim.
  const int rim_u = rim_of(grid_.width()), rim_v = rim_of(grid_.height());
  to.touches_border = from.left <= rim_u || from.top <= rim_v || from.right + 1 >= grid_.width() - rim_u ||
                      from.bottom + 1 >= grid_.height() - rim_v;
  note_extent(camera, to);
}

void AditChain::draw(StageImages& images) const {
  const auto stops = [](const CellPlane& plane) {
    return [&plane](int u, int v) { return static_cast<float>(plane.row(v)[u]) / kStop; };
  };
  images.light = enlarged<float>(grid_, frame_width_px_, frame_height_px_, stops(light_));
  images.enclosure = enlarged<float>(grid_, frame_width_px_, frame_height_px_, stops(map_));
  std::array<std::uint8_t, 256> rank{};
  for (int i = 0; i < candidates_.count; ++i) {
    const Candidate& c = candidates_.list[static_cast<std::size_t>(i)];
    rank[c.owner] = static_cast<std::uint8_t>(i + 1);
  }
  images.openings = enlarged<std::uint8_t>(grid_, frame_width_px_, frame_height_px_,
                                           [&](int u, int v) { return rank[search_.owner_of(u, v)]; });
}

}  // namespace adit
