// The options that say how frames are judged, the same for every subcommand that judges frames.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/finder.hpp"
#include "adit/io/configuration.hpp"
#include "adit/lamp.hpp"

namespace adit::tools {

struct FinderOptions {
  std::string method;
  std::string config_file;
  std::string camera_file;
  std::string lamp_file;
  std::vector<std::string> settings;
};

/// Adds --config and --set.
void add_configuration_options(CLI::App& subcommand, FinderOptions& options);
/// Adds --method, --config, --camera and --set.
void add_finder_options(CLI::App& subcommand, FinderOptions& options);

/// Adds --lamp.
void add_lamp_option(CLI::App& subcommand, FinderOptions& options);

/// The defaults, with --config over them, then --method, then each --set. @throws io::ConfigError
[[nodiscard]] io::Configuration configuration_of(const FinderOptions& options);

/// The camera of --camera, if given. @throws io::ConfigError
[[nodiscard]] std::optional<Camera> camera_of(const FinderOptions& options);

/// The pattern of --lamp; none where it is not given. @throws io::ConfigError
[[nodiscard]] LampPattern lamp_of(const FinderOptions& options);

/// A finder for the configuration and, if there is one, the camera.
[[nodiscard]] OpenSpaceFinder make_finder(const FinderConfig& config, const std::optional<Camera>& camera);

}  // namespace adit::tools
