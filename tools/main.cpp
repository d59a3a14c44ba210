// `adit`: one program, a file for each subcommand.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "adit/io/errors.hpp"
#include "exit_code.hpp"
#include "subcommands.hpp"
#include "version.hpp"

namespace {

using adit::tools::ExitCode;

ExitCode refuse(ExitCode code, const std::exception& reason) {
  std::fprintf(stderr, "adit: %s\n", reason.what());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app{"Where the open space is, in the dark, from one camera.", "adit"};
  app.set_version_flag("--version", "adit " ADIT_VERSION);
  app.require_subcommand(1);
  app.footer("Example: adit run data/clip.avi --csv headings.csv");
  ExitCode exit_code = adit::tools::kSuccess;
  adit::tools::add_run(app, exit_code);
  adit::tools::add_explain(app, exit_code);
  adit::tools::add_config(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? adit::tools::kSuccess : adit::tools::kUsage;
  } catch (const adit::io::ConfigError& e) {
    return refuse(adit::tools::kBadConfiguration, e);
  } catch (const adit::io::InputError& e) {
    return refuse(adit::tools::kBadInput, e);
  } catch (const adit::io::OutputError& e) {
    return refuse(adit::tools::kOutputNotWritten, e);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    return refuse(adit::tools::kUnexpected, e);
  }
}
