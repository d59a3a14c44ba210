#include "finder_options.hpp"

#include <CLI/CLI.hpp>

#include "adit/io/camera_file.hpp"
#include "adit/io/lamp_file.hpp"

namespace adit::tools {

void add_configuration_options(CLI::App& subcommand, FinderOptions& options) {
  subcommand.add_option("--config", options.config_file, "Settings, as 'adit config' prints them")
      ->type_name("FILE.yaml");
  // One value each time, or it would swallow the inputs that follow.
  subcommand.add_option("--set", options.settings, "One setting, over those of --config; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_finder_options(CLI::App& subcommand, FinderOptions& options) {
  subcommand.add_option("--method", options.method, "Chain of stages: paper, adit")->type_name("NAME");
  add_configuration_options(subcommand, options);
  subcommand.add_option("--camera", options.camera_file, "Calibration, a ROS camera_info file")->type_name("FILE.yaml");
}

void add_lamp_option(CLI::App& subcommand, FinderOptions& options) {
  subcommand.add_option("--lamp", options.lamp_file, "The lamp's pattern, as 'adit run --learn-lamp' wrote it")
      ->type_name("FILE.yaml");
}

io::Configuration configuration_of(const FinderOptions& options) {
  io::Configuration configuration;
  if (!options.config_file.empty()) io::read_configuration(options.config_file, configuration);
  if (!options.method.empty()) {
    if (!parse(options.method, configuration.finder.method)) {
      throw CLI::ValidationError("--method", "'" + options.method + "' is not known; known are: paper, adit");
    }
  }
  for (const std::string& setting : options.settings) io::set_field(setting, configuration);
  return configuration;
}

std::optional<Camera> camera_of(const FinderOptions& options) {
  if (options.camera_file.empty()) return std::nullopt;
  return Camera(io::read_camera(options.camera_file));
}

LampPattern lamp_of(const FinderOptions& options) {
  return options.lamp_file.empty() ? LampPattern{} : io::read_lamp(options.lamp_file);
}

OpenSpaceFinder make_finder(const FinderConfig& config, const std::optional<Camera>& camera) {
  return camera ? OpenSpaceFinder(config, *camera) : OpenSpaceFinder(config);
}

}  // namespace adit::tools
