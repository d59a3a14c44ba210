// The subcommands of `adit`: each lives in a file of its own and adds itself to the program.
#pragma once

#include <CLI/App.hpp>

#include "exit_code.hpp"

namespace adit::tools {

// Each adds one subcommand whose callback does the work and sets exit_code, or throws io::InputError,
// io::ConfigError or io::OutputError, which main() prints as one line and turns into an exit code.
void add_run(CLI::App& app, ExitCode& exit_code);
void add_explain(CLI::App& app, ExitCode& exit_code);
void add_report(CLI::App& app, ExitCode& exit_code);
void add_eval(CLI::App& app, ExitCode& exit_code);
void add_view(CLI::App& app, ExitCode& exit_code);  ///< only where cpp-httplib is there
void add_mark(CLI::App& app, ExitCode& exit_code);  ///< the same
void add_bench(CLI::App& app, ExitCode& exit_code);
void add_fly(CLI::App& app, ExitCode& exit_code);     ///< only in builds with the simulator
void add_render(CLI::App& app, ExitCode& exit_code);  ///< the same
void add_merge(CLI::App& app, ExitCode& exit_code);
void add_config(CLI::App& app, ExitCode& exit_code);
void add_gz(CLI::App& app, ExitCode& exit_code);  ///< only where Gazebo's transport is there

}  // namespace adit::tools
