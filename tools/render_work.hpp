// The frames of `adit render`: where from, how exposed, with what truth.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adit/sim/viewpoints.hpp"
#include "exit_code.hpp"
#include "fly_setup.hpp"
#include "pose_file.hpp"
#include "render_outputs.hpp"

namespace adit::tools {

/// What is to be made.
struct RenderWork {
  std::string out;
  std::int64_t frames = 0;
  std::uint64_t seed = 1;
  std::vector<FiledPose> poses;  ///< empty: drawn
  int jobs = 1;
  bool quiet = false;
  std::string settings_yaml;
  DatasetNote note;
};

/// @throws io::ConfigError, io::OutputError
[[nodiscard]] ExitCode render_frames(const RenderWork& work, const FlySettings& settings,
                                     const sim::ViewpointConfig& viewpoints, const Site& site);

}  // namespace adit::tools
