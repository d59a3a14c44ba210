// What `adit eval` is judged on: marked frames (openings.json) and rendered ones (truth.csv of `adit render`).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/eval/score.hpp"

namespace adit::tools {

struct EvalFrame {
  std::filesystem::path image;
  std::string name;              ///< within its set
  std::string place;             ///< frames of one place are alike
  int sequence = -1;             ///< as eval::ScoredFrame
  double yaw_rad = 0.0;          ///< the same
  eval::FrameTruth truth;        ///< of rendered frames whole only after complete_truth()
  std::filesystem::path ranges;  ///< 16-bit PNG in mm; empty for marked frames
  double deepest_m = eval::kUnknown;
  std::optional<CameraModel> camera;        ///< that the set brings
  std::optional<std::pair<int, int>> size;  ///< px, that marks were made for
};

struct EvalSet {
  std::string name;
  std::vector<EvalFrame> frames;
};

/// @param path  a folder with openings.json or truth.csv, or one of these files; or a folder of such folders, which
///              together are one set.
/// @param sequence  the frames of a place follow each other in time, in the order of their names.
/// @throws io::InputError one line that names the file and what is wrong with it.
[[nodiscard]] EvalSet read_eval_set(const std::filesystem::path& path, bool sequence);

/// "vypustek22-0030.png" -> "vypustek22": the stem without the digits at its end and the - _ . or blank before them.
/// Nothing is left of a name of digits alone: then all frames of the set are one place.
[[nodiscard]] std::string place_of_name(const std::string& file_name);

/// Of a rendered frame: reads its ranges and sees which branches are in sight and what the frame shows.
/// @throws io::InputError
void complete_truth(EvalFrame& frame, const Camera& camera, const eval::ScoreConfig& config);

}  // namespace adit::tools
