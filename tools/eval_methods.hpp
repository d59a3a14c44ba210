// Who answers in `adit eval`: our methods, the baselines beside them, and tables of others.
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/eval/score.hpp"
#include "adit/finder.hpp"
#include "eval_sets.hpp"

namespace adit::tools {

/// A frame as it is shown to a method.
struct ShownFrame {
  const EvalFrame& frame;
  const cv::Mat& pixels;
  const Camera& camera;
  bool calibrated;       ///< the camera is the set's own, not a stand-in
  std::uint64_t number;  ///< over all sets
};

/// What it said.
struct GivenAnswer {
  eval::Answer answer;
  std::string status;  ///< "found", or why not
};

/// One method at work, for one thread.
class Answerer {
 public:
  virtual ~Answerer() = default;
  [[nodiscard]] virtual GivenAnswer answer(const ShownFrame& shown) = 0;
};

/// A method by name, and how to make one.
struct Contender {
  std::string name;
  bool baseline = false;
  int scanned_k = 0;  ///< > 0: one of those of which the best is kept
  std::function<std::unique_ptr<Answerer>()> make;
};

/// Names of all methods that there are.
[[nodiscard]] std::vector<std::string> known_methods();

/// @param lamp  what is known of the vehicle's lamp, for method `adit`.
[[nodiscard]] Contender finder_contender(const std::string& name, const FinderConfig& config,
                                         const LampPattern& lamp = {});
/// A table of somebody else's answers, with the columns of `adit run --csv`: source, status, confidence, u_px, v_px
/// (or azimuth_deg, elevation_deg), openings. @throws io::InputError
[[nodiscard]] Contender table_contender(const std::string& name, const std::string& path);
/// Image centre, a random place, the darkest place, and the paper's chain as published and with each other K.
[[nodiscard]] std::vector<Contender> baselines(const FinderConfig& config, std::uint64_t seed);

inline constexpr int kPublishedK = 10;
inline constexpr const char* kPublishedName = "paper_k10";
inline constexpr int kScannedFewest = 2;
inline constexpr int kScannedMost = 20;

}  // namespace adit::tools
