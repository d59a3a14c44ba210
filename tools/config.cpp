// `adit config`: every setting with its default, as a file that --config reads.
#include <CLI/CLI.hpp>
#include <memory>

#include "adit/io/output_file.hpp"
#include "finder_options.hpp"
#include "subcommands.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

void print_configuration(const FinderOptions& options) {
  const std::string yaml = "# Settings of adit " ADIT_VERSION
                           ". Change what you need, drop the rest, and pass the file with --config.\n\n" +
                           io::to_yaml(configuration_of(options));
  io::write_file("-", yaml);
}

}  // namespace

void add_config(CLI::App& app, ExitCode& exit_code) {
  CLI::App* config = app.add_subcommand("config", "Print all settings as YAML, with comments");
  auto options = std::make_shared<FinderOptions>();
  add_configuration_options(*config, *options);
  config->footer("Example: adit config --set omega=0.9 > adit.yaml");
  config->callback([options, &exit_code] {
    print_configuration(*options);
    exit_code = kSuccess;
  });
}

}  // namespace adit::tools
