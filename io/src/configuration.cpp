#include "adit/io/configuration.hpp"

#include "adit/io/settings.hpp"

namespace adit::io {
namespace {

Settings settings_of(Configuration& configuration) {
  Settings settings;
  visit_sections(configuration,
                 [&settings](const char* section_name, auto& section) { settings.add(section_name, section); });
  return settings;
}

}  // namespace

void read_yaml(std::string_view text, std::string_view name, Configuration& configuration) {
  settings_of(configuration).read_yaml(text, name);
}

void read_configuration(const std::filesystem::path& path, Configuration& configuration) {
  settings_of(configuration).read_file(path);
}

void set_field(std::string_view assignment, Configuration& configuration) {
  settings_of(configuration).set(assignment);
}

std::string to_yaml(const Configuration& configuration) {
  Configuration copy = configuration;
  return settings_of(copy).to_yaml();
}

}  // namespace adit::io
