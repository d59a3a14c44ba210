// `adit`: one program, a file for each subcommand.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <sstream>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "exit_code.hpp"
#include "help_format.hpp"
#include "manual_pages.hpp"
#include "progress.hpp"
#include "subcommands.hpp"
#include "version.hpp"

namespace {

using adit::tools::ExitCode;

ExitCode refuse(ExitCode code, const std::exception& reason) {
  adit::tools::print_line(std::string("adit: ") + reason.what());
  return code;
}

/// Help and version: also these may end on a full disk.
ExitCode tell(const std::string& text) {
  try {
    adit::io::OutputFile out("-");
    out.write(text);
    out.commit();
    return adit::tools::kSuccess;
  } catch (const adit::io::OutputError& e) {
    return refuse(adit::tools::kOutputNotWritten, e);
  }
}

/// What goes wrong is said by us, once, with the file's name; the libraries beneath stay silent.
void silence_libraries() {
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // AV_LOG_QUIET; read when the first video is opened
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  std::cerr.rdbuf(nullptr);  // cv::imdecode speaks here
  // Frames are shared out over our own threads.
  cv::setNumThreads(1);
}

/// "--jobs: Value 0 not in range 1 to 256 (see adit run --help)", on one line.
std::string usage_fault(const CLI::App* app, const CLI::Error& error) {
  std::string program = "adit";
  for (const CLI::App* chosen : app->get_subcommands()) program += " " + chosen->get_name();
  const std::vector<std::string> unknown = app->remaining();
  const std::string what = app->get_subcommands().empty() && !unknown.empty()
                               ? "'" + unknown.front() + "' is no subcommand"
                               : std::string(error.what());
  return "adit: " + what + " (see " + program + " --help)\n";
}

ExitCode run(int argc, char** argv) {
  CLI::App app{"Where the open space is, in the dark, from one camera.", "adit"};
  app.set_version_flag("--version", "adit " ADIT_VERSION, "The version");
  app.formatter(std::make_shared<adit::tools::HelpFormat>());
  app.set_help_flag("-h,--help", "This page");
  app.require_subcommand(1);
  app.failure_message(usage_fault);
  app.footer("Example: adit run data/clip.avi --csv headings.csv");
  ExitCode exit_code = adit::tools::kSuccess;
  adit::tools::add_run(app, exit_code);
  adit::tools::add_explain(app, exit_code);
  adit::tools::add_report(app, exit_code);
  adit::tools::add_eval(app, exit_code);
#ifdef ADIT_WITH_HTTP
  adit::tools::add_view(app, exit_code);
  adit::tools::add_mark(app, exit_code);
#endif
#ifdef ADIT_WITH_SIM
  adit::tools::add_fly(app, exit_code);
  adit::tools::add_render(app, exit_code);
#endif
#ifdef ADIT_WITH_GZ
  adit::tools::add_gz(app, exit_code);
#endif
  adit::tools::add_merge(app, exit_code);
  adit::tools::add_bench(app, exit_code);
  adit::tools::add_config(app, exit_code);
  try {
    // For the build alone (cmake/install.cmake): no option of a person's.
    if (argc == 3 && std::string_view(argv[1]) == "--write-manual") {
      adit::tools::write_manual(app, argv[2]);
      return adit::tools::kSuccess;
    }
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& e) {  // --help, --version
    std::ostringstream text;
    app.exit(e, text);
    return tell(text.str());
  } catch (const CLI::ParseError& e) {
    std::ostringstream text;
    app.exit(e, text, text);
    std::string line = text.str();
    if (!line.empty() && line.back() == '\n') line.pop_back();
    adit::tools::print_line(line);
    return adit::tools::kUsage;
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
    silence_libraries();
    return run(argc, argv);
  } catch (const std::exception& e) {
    return refuse(adit::tools::kUnexpected, e);
  }
}
