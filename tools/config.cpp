#include "subcommands.hpp"

namespace adit::tools {

void add_config(CLI::App& app, ExitCode& exit_code) {
  CLI::App* config = app.add_subcommand("config", "Print the defaults as YAML, with comments");
  config->callback([&exit_code] { exit_code = kUnexpected; });
}

}  // namespace adit::tools
