// Everything a person may set, from YAML files and from the command line. The fields, their units and ranges stand in
// adit/fields.hpp, their defaults in the structs: nothing is said twice.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/navigator.hpp"
#include "adit/navigator_fields.hpp"

namespace adit::io {

/// The sections of a configuration file, and all that `--set` reaches.
struct Configuration {
  FinderConfig finder;
  HeadingConfig heading;
  ColumnRangeConfig column_range;  ///< this and the rest: of the navigator
  RangeMemoryConfig range_memory;
  TrackerConfig tracker;
  SteeringConfig steering;
  FrameWatchConfig frame_watch;
  LensWatchConfig lens_watch;
};

/// Calls visit(section name, section) for each section of a Configuration, which may be const.
template <class Conf, class Visitor>
void visit_sections(Conf& configuration, Visitor&& visit) {
  visit("finder", configuration.finder);
  visit("heading", configuration.heading);
  visit("column_range", configuration.column_range);
  visit("range_memory", configuration.range_memory);
  visit("tracker", configuration.tracker);
  visit("steering", configuration.steering);
  visit("frame_watch", configuration.frame_watch);
  visit("lens_watch", configuration.lens_watch);
}

/// The sections that a navigator is made with: all of them.
[[nodiscard]] inline NavigatorConfig navigator_config_of(const Configuration& configuration) {
  return {configuration.finder,  configuration.heading,  configuration.column_range, configuration.range_memory,
          configuration.tracker, configuration.steering, configuration.frame_watch,  configuration.lens_watch};
}

/// Reads a YAML text over `configuration`: fields it does not name keep their value.
/// @param name  the file's name, for messages.
/// @throws ConfigError "NAME:LINE: ..." for broken YAML, an unknown section or key (with the nearest known one), a key
///         given twice, a value of the wrong type or out of range.
void read_yaml(std::string_view text, std::string_view name, Configuration& configuration);

/// The same for a file. @throws ConfigError also when the file is missing, empty or unreadable.
void read_configuration(const std::filesystem::path& path, Configuration& configuration);

/// Takes one `--set` assignment, "omega=0.9" or "finder.omega=0.9".
/// @throws ConfigError "--set omega=9: ...".
void set_field(std::string_view assignment, Configuration& configuration);

/// All fields as YAML, each with its meaning, unit, range and source in a comment. read_yaml() of it gives the same
/// configuration.
[[nodiscard]] std::string to_yaml(const Configuration& configuration);

}  // namespace adit::io
