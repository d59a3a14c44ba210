// All frames shown to all methods, and what came of it.
#pragma once

#include <string>
#include <vector>

#include "adit/eval/figures.hpp"
#include "eval_methods.hpp"
#include "eval_sets.hpp"
#include "parts.hpp"

namespace adit::tools {

struct EvalWork {
  std::vector<EvalSet> sets;
  std::vector<Contender> contenders;
  std::optional<CameraModel> camera;  ///< of --camera, for sets that bring none
  FinderConfig finder;                ///< its field of view, where nothing is known of the camera
  eval::ScoreConfig score;
  eval::BootstrapConfig bootstrap;
  int jobs = 1;
  bool quiet = false;
  bool pictures = false;    ///< for the gallery
  Shard shard;              ///< given: only its frames are judged, and there are no figures
  std::vector<Part> parts;  ///< given: frames are not judged, but taken from them
};

/// One method on one frame.
struct Judged {
  GivenAnswer given;
  eval::FrameScore score;
};

/// One frame, all methods.
struct JudgedFrame {
  bool readable = false;
  std::string fault;                          ///< why it is not
  int width = 0;                              ///< px
  int height = 0;                             ///< px
  std::vector<Judged> methods;                ///< in the order of the contenders
  std::vector<unsigned char> thumbnail;       ///< JPEG; with EvalWork::pictures
  std::vector<std::vector<Pixel>> open_area;  ///< of a rendered frame; the same
  std::vector<Pixel> branches;                ///< in sight
  std::optional<Pixel> passage, deepest;
};

/// One line of the table: a method on a set.
struct MethodResult {
  std::string name;
  std::string about;  ///< "K = 5, tuned on this set"; mostly empty
  bool baseline = false;
  std::vector<std::size_t> contender;  ///< whose answer counts, set by set (of those that are in)
  eval::Figures figures;
};

struct SetResult {
  std::string name;
  std::vector<std::size_t> sets;  ///< one, or all
  std::vector<MethodResult> methods;
};

struct EvalResult {
  std::vector<std::vector<JudgedFrame>> frames;  ///< set by set
  std::vector<SetResult> sets;                   ///< each set; of several also all together, last
  int unreadable = 0;
  bool interrupted = false;
};

/// Frames are told when they cannot be read; the rest goes on.
/// @throws io::InputError, io::ConfigError when nothing can be judged.
[[nodiscard]] EvalResult evaluate(EvalWork& work);

}  // namespace adit::tools
