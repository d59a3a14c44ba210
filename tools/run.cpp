#include "subcommands.hpp"

namespace adit::tools {

void add_run(CLI::App& app, ExitCode& exit_code) {
  CLI::App* run = app.add_subcommand("run", "Find the open space in images, folders, videos or a camera");
  run->callback([&exit_code] { exit_code = kUnexpected; });
}

}  // namespace adit::tools
