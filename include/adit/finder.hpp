// OpenSpaceFinder: one frame in, the open space out. Figure 1 of the paper is OpenSpaceFinder::find.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adit/api.hpp"
#include "adit/camera.hpp"
#include "adit/image.hpp"
#include "adit/kmeans.hpp"
#include "adit/lamp.hpp"
#include "adit/region.hpp"
#include "adit/scattering_depth.hpp"

namespace ADIT_API adit {

/// Which chain of stages answers.
enum class Method {
  kPaper,  ///< as published
  kAdit,   ///< the dark place that lit rock encloses
};

/// How the grey levels are clustered.
enum class Clustering { kExact, kLloyd };

/// Every constant of the chain. Defaults stand here and nowhere else; unit, range, meaning and source of each field
/// stand in visit_fields() (fields.hpp), from which the YAML, the command line and the docs are made.
struct FinderConfig {
  Method method = Method::kAdit;
  int patch_size_px = 0;
  int patch_size_vga_px = 15;
  int structuring_element_size_px = 0;
  int structuring_element_size_vga_px = 15;
  double omega = 0.95;
  double atmospheric_light_fraction = 0.001;
  double transmission_min = 0.01;
  double scattering_coefficient = 1.0;
  int cluster_count = 10;
  Clustering clustering = Clustering::kExact;
  int lloyd_seed = 1;
  int lloyd_starts = 1;
  int lloyd_iterations_max = 10;
  double lloyd_tolerance = 0.0001;
  int grey16_depth_bits = 16;
  double assumed_hfov_deg = 75.0;
  double too_dark_light_max = 6.0;
  int too_bright_level_min = 200;
  int contrast_levels_min = 4;
  double area_fraction_min = 0.002;
  // Method `adit` only:
  double light_gamma = 2.2;
  double noise_level = 2.0;
  double horizon_spread_deg = 12.0;
  double horizon_floor = 0.15;
  double way_odds_min = -1.0;
  double dust_veil_min = 0.7;
};

/// The published method with the constants of the paper, for comparison.
[[nodiscard]] inline FinderConfig paper_preset() {
  FinderConfig config;
  config.method = Method::kPaper;
  return config;
}

/// Why a configuration is refused: "omega: 1.5 is not in [0.01, 1]; set a value in this range".
/// Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const FinderConfig& config);

/// What a size given for 640 x 480 is at another width: scaled with the width (the same angle for the same lens),
/// to the nearest odd number (upwards in a tie), at least 1 and at most 1023. 15 gives 15 at 640, 91 at 3840, 7 at
/// 320.
[[nodiscard]] int scaled_size_px(int size_vga_px, int width_px) noexcept;

/// What became of a frame. Only kFound comes with a bearing to follow.
enum class Status : std::uint8_t {
  kFound,
  kTooDark,     ///< atmospheric light below too_dark_light_max: lamp out, lens covered
  kTooBright,   ///< even the darkest place is at or above too_bright_level_min: daylight, exposure too long; method
                ///< `adit`: also a tenth of the frame at the end of the range where the rest looks like dust
  kNoContrast,  ///< darkest and brightest place differ by less than contrast_levels_min: fog, one grey value
  kNoRegion,    ///< the darkest cluster is smaller than area_fraction_min: a speck, no opening
  kBadFrame,    ///< not a frame: see fault_of(ImageView)
  kWrongSize,   ///< the frame is not of the camera model's size
  // Method `adit`, from one frame:
  kNoOpening,    ///< lit rock and no dark place that it encloses: wall ahead, dead end
  kBlockedLens,  ///< something close to the lens: no detail, or a bright blur
  kDust,         ///< the lamp's own light thrown back by dust hides all rock
  // From a sequence (navigator.hpp); a single frame never gives these:
  kFrozenFrame,  ///< the same pixels again and again: the camera hangs
  kTornFrame,    ///< two frames in one, or rows without signal
};
inline constexpr int kStatusCount = 12;

/// By which rule the best opening was chosen.
enum class Rule : std::uint8_t {
  kNone,            ///< nothing was chosen
  kDarkestCluster,  ///< method `paper`: centroid of the darkest cluster
  kEnclosed,        ///< method `adit`: the dark place that lit rock encloses best
  kOpenSided,       ///< method `adit`: a dark place that runs out of the frame, lit rock on the sides that are seen
  kVeil,            ///< method `adit`, dust: the middle of the air, where rock adds least to the veil
  kFlash,           ///< method `adit`, pairs of frames: dark in the difference of lamp on and lamp off
};
inline constexpr int kRuleCount = 6;

/// What disturbs the view. Set whatever the status is, so that a caller can slow down or switch a lamp on.
/// Method `adit` only; all false with `paper`.
struct SightFlags {
  bool dust = false;          ///< veil_fraction is above dust_veil_min
  bool glare = false;         ///< an emitter that is not the vehicle's lamp is in view
  bool blocked_lens = false;  ///< see Status::kBlockedLens
  bool too_dark = false;      ///< the picture is usable, if at all, only after amplification: noise counts
  bool too_bright = false;    ///< a large part of the frame is at the end of the range
  bool dirty_lens = false;    ///< a spot on the lens was told from an opening (lens_watch.hpp); sequences only

  [[nodiscard]] bool any() const noexcept {
    return dust || glare || blocked_lens || too_dark || too_bright || dirty_lens;
  }
};

/// "found", "too_dark", ...: the spelling in tables, messages and YAML.
[[nodiscard]] std::string_view to_string(Status status) noexcept;
[[nodiscard]] std::string_view to_string(Rule rule) noexcept;
[[nodiscard]] std::string_view to_string(Method method) noexcept;
[[nodiscard]] std::string_view to_string(Clustering clustering) noexcept;
/// The other way round; false and no change when the name is unknown.
[[nodiscard]] bool parse(std::string_view name, Status& status) noexcept;
[[nodiscard]] bool parse(std::string_view name, Rule& rule) noexcept;
[[nodiscard]] bool parse(std::string_view name, Method& method) noexcept;
[[nodiscard]] bool parse(std::string_view name, Clustering& clustering) noexcept;

/// The stages, in order, as timed and as drawn by `adit explain`.
enum class Stage : std::uint8_t { kDarkChannel, kScatteringDepth, kClosing, kClusters, kMoments };
inline constexpr int kStageCount = 5;
[[nodiscard]] std::string_view to_string(Stage stage) noexcept;

/// One opening: a place in the frame and why it is believed to be open.
struct Opening {
  Pixel centroid_px;
  NormalisedPoint point;  ///< (sx, sy)
  Bearing bearing;
  double area_fraction = 0.0;  ///< of the frame, 0 to 1
  double confidence = 0.0;     ///< 0 to 1, see OpenSpace::confidence

  // How far it reaches. Method `paper`: the box that the spread of the cluster suggests (centroid +- sqrt(3) sigma).
  Pixel top_left_px;             ///< of the upright box about it, inside the frame
  Pixel bottom_right_px;         ///< the last pixel that belongs to the box
  double half_width_rad = 0.0;   ///< half the angle between the box's left and right edge
  double half_height_rad = 0.0;  ///< half the angle between its upper and lower edge
  double score = 0.0;            ///< what the openings are ordered by, 0 to 1: how opening-like, see docs/method.md
  double contrast = 0.0;         ///< how much darker it is than the rock on its rim: 0 not at all, 1 black
  bool touches_border = false;   ///< cut by the edge of the frame: extent and bearing are those of the part in view
};
inline constexpr int kOpeningCountMax = 8;

/// The answer for one frame, with its evidence. Plain numbers: copying it allocates nothing.
struct OpenSpace {
  Status status = Status::kBadFrame;
  /// In [0, 1]; 0 unless found. Method `adit`: the share of such answers that is right (docs/method.md).
  /// Method `paper`: fill * contrast, where fill is fill_of(moments) (is the darkest cluster
  /// one solid patch, so that its mean lies on it?) and contrast is how much darker that cluster is than the rest of
  /// the frame, (rest - cluster) / rest in mean level of the closed dark channel. It describes the
  /// cluster and is not a probability: a solid dark wall also scores well.
  double confidence = 0.0;
  /// Openings, the best first. [0] is what centroid and bearing below repeat. Empty unless found.
  std::array<Opening, kOpeningCountMax> openings{};
  int opening_count = 0;
  Rule rule = Rule::kNone;  ///< by which openings[0] was chosen; kNone unless found

  SightFlags flags;
  /// Light thrown back by dust between camera and rock, as a share of the light that the frame's rock sends (median):
  /// 0 clear air, 1 nothing but veil. Without a known lamp and camera this cannot be brought to metres. Method `adit`.
  double veil_fraction = 0.0;

  Pixel centroid_px;      ///< eq. (9); meaningful only when found, as are the next three
  NormalisedPoint point;  ///< eq. (10): (sx, sy)
  Bearing bearing;
  double area_fraction = 0.0;  ///< of the frame

  double atmospheric_light = 0.0;  ///< grey levels, 0 to 255; judged frames only
  int darkest_level = 0;           ///< of the closed dark channel, 0 to 255
  int brightest_level = 0;
  int threshold_level = 0;  ///< the darkest cluster holds the levels darkest_level to threshold_level
  Moments moments;          ///< of the darkest cluster
  Clusters clusters;

  std::array<std::int64_t, kStageCount> stage_ns{};  ///< time each stage took, by a steady clock
  std::int64_t total_ns = 0;                         ///< the whole chain; 0 for a frame that was not judged

  [[nodiscard]] bool found() const noexcept { return status == Status::kFound; }
};

/// Pictures of the stages, for people. Each is width x height, rows one after the other.
struct StageImages {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> dark_channel;   ///< grey levels
  std::vector<float> transmission;          ///< of the dark channel, 0 to 1
  std::vector<float> scattering_depth;      ///< of the dark channel, unitless, small is far
  std::vector<float> closing;               ///< the closed scattering depth, unitless
  std::vector<std::uint8_t> closing_level;  ///< the same as grey levels of the closed dark channel
  std::vector<std::uint8_t> cluster;        ///< 0 is the darkest; empty if no clusters were made
  std::vector<std::uint8_t> binary;         ///< 255 in the darkest cluster, else 0; empty if no clusters were made
  // Method `adit` only, else empty; the stages above are then those of `paper` on the same frame, for comparison:
  std::vector<float> light;      ///< of the scene, stops below full scale, on the method's coarse grid
  std::vector<float> enclosure;  ///< score map: stops by which lit rock rises about a place, weighted by elevation
  std::vector<std::uint8_t> openings;  ///< 1 in the best opening, 2 in the next, ...; 0 elsewhere
};

/// The chain of stages. Has no memory from frame to frame but its buffers: a frame is judged alone.
/// One object per thread; different objects are independent.
class OpenSpaceFinder {
 public:
  /// Frames of any size; directions come from an ideal pinhole with assumed_hfov_deg.
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit OpenSpaceFinder(const FinderConfig& config = {});
  /// Frames of the camera's size only.
  OpenSpaceFinder(const FinderConfig& config, const Camera& camera);
  ~OpenSpaceFinder();
  OpenSpaceFinder(OpenSpaceFinder&&) noexcept;
  OpenSpaceFinder& operator=(OpenSpaceFinder&&) noexcept;

  [[nodiscard]] const FinderConfig& config() const noexcept;

  /// Sizes all buffers for frames of this size, so that find() never allocates on them. find() does the same by itself
  /// at the first frame of a new size, and answers kBadFrame if there is no memory for it.
  /// @throws std::invalid_argument for a side outside [kSideMin_px, kSideMax_px], std::bad_alloc.
  void reserve(int width, int height);

  /// Judges one frame. Reads the pixels, never writes them. Allocates nothing once sized.
  [[nodiscard]] OpenSpace find(const ImageView& frame) noexcept;

  /// Judges a pair of frames, one with the vehicle's lamp on and one with it off, in any order, taken from nearly the
  /// same place with the same exposure: what the lamp alone lights. Foreign lamps cancel out. Without a difference:
  /// kTooDark. Method `adit`; `paper` judges the brighter one. Frames of two sizes: kBadFrame.
  [[nodiscard]] OpenSpace find_flash(const ImageView& one, const ImageView& other) noexcept;

  /// From now on frames are judged with this pattern of the vehicle's lamp taken out. Method `adit`; in dust it is not
  /// used, since the veil that is fitted there holds the pattern. A pattern of 0 frames is none.
  void set_lamp(const LampPattern& pattern) noexcept;
  /// What the frame judged last shows of the lamp. Method `adit`; else not usable.
  [[nodiscard]] LampGlimpse lamp_glimpse() const noexcept;

  /// As find(), and the pictures of its stages. Allocates. @throws std::bad_alloc
  [[nodiscard]] OpenSpace explain(const ImageView& frame, StageImages& images);

 private:
  struct Chain;
  std::unique_ptr<Chain> chain_;
};

}  // namespace adit
