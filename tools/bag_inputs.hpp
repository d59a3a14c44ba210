// Inputs of `adit run` that may be recordings of ROS 1.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/io/frame_source.hpp"
#include "finder_options.hpp"

namespace adit::tools {

/// By its name: FILE.bag.
[[nodiscard]] bool is_bag(const std::string& input);

/// As io::open_sources, and bags. @param topic  of the images in bags; empty: the only one.
/// @throws io::InputError also for bags where adit was built without them.
[[nodiscard]] std::vector<std::unique_ptr<io::FrameSource>> sources_of(const std::vector<std::string>& inputs,
                                                                       const io::SourceOptions& options,
                                                                       const std::string& topic);

/// The camera of --camera; without it, that which a single bag was recorded with. @throws io::ConfigError,
/// io::InputError
[[nodiscard]] std::optional<Camera> camera_of_inputs(const FinderOptions& options,
                                                     const std::vector<std::string>& inputs, const std::string& topic);

}  // namespace adit::tools
