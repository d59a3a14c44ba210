// What `adit fly` flies: the world, the rig, and every setting, from files and the command line.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adit/io/settings.hpp"
#include "adit/sim/course.hpp"
#include "adit/sim/flight.hpp"
#include "adit/sim/render.hpp"
#include "adit/sim/world.hpp"

namespace adit::tools {

/// As given on the command line.
struct FlyOptions {
  std::string course;
  std::string world_file;
  std::vector<double> start;  ///< x, y, z, yaw_deg
  std::vector<std::string> models;
  double mesh_scale = 1.0;
  std::string mesh_up = "file";
  bool world_lights = false;
  bool door = false;
  std::string config_file;
  std::vector<std::string> settings;
  std::string lamp;
  std::string method;
  std::string prefer;
  double speed_m_s = 0.0;  ///< 0: the setting's
  double time_s = 0.0;     ///< 0: the setting's
  double dust_1_m = -1.0;  ///< negative: the setting's
};

/// Every constant of a flight, of what it flies with and of what it flies in.
struct FlySettings {
  sim::FlightSettings flight;
  sim::RigConfig rig = sim::rig_preset("flood_460lux");
  sim::RenderConfig render;
  sim::CourseConfig course;  ///< meaningless with a world file
};

/// The sections of FlySettings, for YAML and `--set`: flight, vehicle, truth, lidar, imu, finder, heading, lamp (all
/// lamps alike), lamps, lens, sensor, dust, dirt, render, course.
[[nodiscard]] io::Settings sections_of(FlySettings& settings);

/// A world and the rays in it.
struct Site {
  sim::World world;
  std::shared_ptr<const sim::RayScene> scene;
};

/// Reads course, preset, configuration and settings, in this order. @throws io::ConfigError, io::InputError
/// @param add_more  adds sections of the subcommand's own to those that may be set.
[[nodiscard]] FlySettings fly_settings_of(const FlyOptions& options,
                                          const std::function<void(io::Settings&)>& add_more = {});

/// Builds or loads the world. @throws io::InputError, io::ConfigError
[[nodiscard]] Site site_of(const FlyOptions& options, const FlySettings& settings);

/// courses/NAME.yaml for a name, or the path itself. @throws io::InputError naming the courses there are.
[[nodiscard]] std::string course_path(const std::string& course);

}  // namespace adit::tools
