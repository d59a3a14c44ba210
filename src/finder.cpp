#include "adit/finder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "band_pass.hpp"
#include "chain.hpp"
#include "opening_extent.hpp"

namespace adit {
namespace {

/// Writes down how long each stage took.
class StageClock {
 public:
  explicit StageClock(OpenSpace& out) noexcept : out_(out), start_(Clock::now()), last_(start_) {}

  void lap(Stage stage) noexcept {
    const auto now = Clock::now();
    out_.stage_ns[static_cast<std::size_t>(stage)] = nanoseconds(last_, now);
    out_.total_ns = nanoseconds(start_, now);
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static std::int64_t nanoseconds(Clock::time_point from, Clock::time_point to) noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(to - from).count();
  }
  OpenSpace& out_;
  Clock::time_point start_;
  Clock::time_point last_;
};

/// Eq. (6) and (7), by either algorithm.
Clusters clusters_of(const LevelTable& depth, const Histogram& histogram, const FinderConfig& config) noexcept {
  if (config.clustering == Clustering::kExact) return cluster_exact(depth, histogram, config.cluster_count);
  return cluster_lloyd(depth, histogram, config.cluster_count,
                       {.seed = static_cast<std::uint64_t>(config.lloyd_seed),
                        .starts = config.lloyd_starts,
                        .iterations_max = config.lloyd_iterations_max,
                        .tolerance = config.lloyd_tolerance});
}

void note_levels(const Histogram& histogram, OpenSpace& out) noexcept {
  const auto in_use = [](std::uint32_t pixels) { return pixels > 0; };
  out.darkest_level = static_cast<int>(std::find_if(histogram.begin(), histogram.end(), in_use) - histogram.begin());
  out.brightest_level =
      255 - static_cast<int>(std::find_if(histogram.rbegin(), histogram.rend(), in_use) - histogram.rbegin());
}

/// How much darker the darkest cluster is than the rest of the frame, in mean level: (rest - cluster) / rest.
double contrast_of(const Histogram& histogram, int threshold_level) noexcept {
  std::array<double, 2> pixels{};
  std::array<double, 2> levels{};
  for (int level = 0; level < 256; ++level) {
    const std::size_t side = level <= threshold_level ? 0 : 1;
    const double weight = histogram[static_cast<std::size_t>(level)];
    pixels[side] += weight;
    levels[side] += weight * level;
  }
  if (pixels[0] == 0.0 || pixels[1] == 0.0) return 0.0;
  return 1.0 - (levels[0] / pixels[0]) / (levels[1] / pixels[1]);
}

/// The order is that of the questions: is there light, is there dark, is there a difference, is there a place.
Status verdict_on(const OpenSpace& seen, const FinderConfig& config) noexcept {
  if (seen.atmospheric_light < config.too_dark_light_max) return Status::kTooDark;
  if (seen.darkest_level >= config.too_bright_level_min) return Status::kTooBright;
  // One cluster: the floor of the transmission has made all levels alike.
  if (seen.brightest_level - seen.darkest_level < config.contrast_levels_min || seen.clusters.count < 2) {
    return Status::kNoContrast;
  }
  if (seen.area_fraction < config.area_fraction_min) return Status::kNoRegion;
  return Status::kFound;
}

/// The box that the spread suggests: an upright rectangle with these second moments reaches sqrt(3) sigma from its
/// mean.
void note_box(const ImageView& frame, const Moments& moments, const Camera& camera, Opening& opening) noexcept {
  const auto reach_px = [&](std::uint64_t second, double mean) {
    return std::sqrt(3.0 * std::max(0.0, static_cast<double>(second) / static_cast<double>(moments.m00) - mean * mean));
  };
  const Pixel mean = opening.centroid_px;
  const double du = reach_px(moments.m20, mean.u_px), dv = reach_px(moments.m02, mean.v_px);
  opening.top_left_px = {std::max(0.0, mean.u_px - du), std::max(0.0, mean.v_px - dv)};
  opening.bottom_right_px = {std::min(frame.width - 1.0, mean.u_px + du), std::min(frame.height - 1.0, mean.v_px + dv)};
  note_extent(camera, opening);
}

void note_opening(const ImageView& frame, const Camera& camera, double confidence, double contrast,
                  OpenSpace& out) noexcept {
  out.point = camera.normalised_of(out.centroid_px);
  out.bearing = camera.bearing_of(out.centroid_px);
  out.confidence = confidence;
  out.rule = Rule::kDarkestCluster;
  Opening& opening = out.openings[0];
  opening.centroid_px = out.centroid_px;
  opening.point = out.point;
  opening.bearing = out.bearing;
  opening.area_fraction = out.area_fraction;
  opening.confidence = confidence;
  opening.score = confidence;
  opening.contrast = contrast;
  note_box(frame, out.moments, camera, opening);
  out.opening_count = 1;
}

}  // namespace

int scaled_size_px(int size_vga_px, int width_px) noexcept {
  constexpr std::int64_t kVgaWidth_px = 640;
  const std::int64_t half = static_cast<std::int64_t>(size_vga_px) * width_px / (2 * kVgaWidth_px);
  return static_cast<int>(std::clamp<std::int64_t>(2 * half + 1, 1, 1023));
}

OpenSpaceFinder::OpenSpaceFinder(const FinderConfig& config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
  chain_ = std::make_unique<Chain>(config);
}

OpenSpaceFinder::OpenSpaceFinder(const FinderConfig& config, const Camera& camera) : OpenSpaceFinder(config) {
  chain_->calibrated_camera = camera;
}

OpenSpaceFinder::~OpenSpaceFinder() = default;
OpenSpaceFinder::OpenSpaceFinder(OpenSpaceFinder&&) noexcept = default;
OpenSpaceFinder& OpenSpaceFinder::operator=(OpenSpaceFinder&&) noexcept = default;

const FinderConfig& OpenSpaceFinder::config() const noexcept { return chain_->config; }

void OpenSpaceFinder::reserve(int width, int height) { chain_->reserve(width, height); }

OpenSpace OpenSpaceFinder::find(const ImageView& frame) noexcept {
  OpenSpace out;
  StageClock clock(out);
  out.status = chain_->admit(frame);
  if (out.status != Status::kFound) return out;
  if (chain_->config.method == Method::kAdit) {
    AditChain& chain = *chain_->workspace->adit;
    chain.take(frame, chain_->config);
    chain.find(chain_->config, chain_->camera(), out);
    clock.lap(Stage::kMoments);
    return out;
  }
  const FinderConfig& config = chain_->config;
  Workspace& work = *chain_->workspace;
  const PlaneView dark = work.dark.pixels();

  dark_channel(frame, work.patch, config.grey16_depth_bits, dark, work.scratch);  // eq. (3), the dark channel
  clock.lap(Stage::kDarkChannel);

  out.atmospheric_light =
      atmospheric_light(frame, config.grey16_depth_bits, dark, config.atmospheric_light_fraction);       // a, eq. (1)
  work.transmission = transmission_table(out.atmospheric_light, config.omega, config.transmission_min);  // eq. (3)
  work.depth = scattering_depth_table(work.transmission, config.scattering_coefficient);                 // eq. (2)
  clock.lap(Stage::kScatteringDepth);

  const PlaneView closed = work.closing = close_margined(work.dark, work.element, work.closed,
                                                         work.scratch);  // eq. (4) and (5): depth rises with the level
  clock.lap(Stage::kClosing);

  const Histogram histogram = histogram_of(closed);
  out.clusters = clusters_of(work.depth, histogram, config);  // eq. (6) and (7)
  out.threshold_level = out.clusters.last_level[0];           // section 2.2: the cluster of the smallest centre
  clock.lap(Stage::kClusters);

  out.moments = moments_of(closed, out.threshold_level, work.columns);  // eq. (8)
  out.centroid_px = centroid_of(out.moments);                           // eq. (9)
  out.area_fraction = static_cast<double>(out.moments.m00) / (static_cast<double>(frame.width) * frame.height);
  note_levels(histogram, out);
  out.status = verdict_on(out, config);
  if (out.found()) {
    const double contrast = contrast_of(histogram, out.threshold_level);
    note_opening(frame, chain_->camera(), fill_of(out.moments) * contrast, contrast, out);  // eq. (10)
  }
  clock.lap(Stage::kMoments);
  return out;
}

OpenSpace OpenSpaceFinder::find_flash(const ImageView& one, const ImageView& other) noexcept {
  OpenSpace out;
  StageClock clock(out);
  out.status = chain_->admit(one);
  if (out.status != Status::kFound) return out;
  if (!fault_of(other).empty() || other.width != one.width || other.height != one.height) {
    out.status = Status::kBadFrame;
    return out;
  }
  if (chain_->config.method != Method::kAdit) {
    const OpenSpace first = find(one), second = find(other);
    return first.atmospheric_light >= second.atmospheric_light ? first : second;
  }
  AditChain& chain = *chain_->workspace->adit;
  chain.take_pair(one, other, chain_->config);
  chain.find(chain_->config, chain_->camera(), out);
  if (out.found()) out.rule = Rule::kFlash;
  clock.lap(Stage::kMoments);
  return out;
}

void OpenSpaceFinder::set_lamp(const LampPattern& pattern) noexcept {
  chain_->lamp = pattern;
  if (chain_->workspace && chain_->workspace->adit) chain_->workspace->adit->set_lamp(pattern);
}

LampGlimpse OpenSpaceFinder::lamp_glimpse() const noexcept {
  if (!chain_->workspace || !chain_->workspace->adit) return {};
  return chain_->workspace->adit->lamp_glimpse();
}

}  // namespace adit
