// `adit report`: a run or a flight as one page.
#include "report.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "file_uses.hpp"
#include "progress.hpp"
#include "report_folder.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

struct Options {
  std::string folder;
  std::string out;
  bool quiet = false;
};

/// The page may be written over an older one alone. @throws CLI::ValidationError
void check_files(const std::filesystem::path& folder, const std::filesystem::path& out, const Report& report) {
  FileUses uses;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error))
    if (entry.path().extension() != ".html") uses.reads("RUN_DIR", entry.path());
  for (const auto& [row, source] : report.table.sources()) {
    uses.reads("the table in RUN_DIR", source);
    uses.reads("the table in RUN_DIR", folder / std::filesystem::path(source).filename());
  }
  uses.writes("--out", out);
}

ExitCode run(const Options& options) {
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(options.folder) / "report.html" : std::filesystem::path(options.out);
  Progress progress(std::nullopt, "frames", options.quiet);
  Report report = report_of_folder(options.folder, [&progress](std::int64_t frames) { progress.show(frames); });
  progress.clear();
  check_files(options.folder, out, report);
  write_report(out, report);
  if (!options.quiet)
    for (const std::string& note : report.notes) print_line("adit: " + note);
  std::printf("%s\n", out.string().c_str());
  return kSuccess;
}

}  // namespace

void add_report(CLI::App& app, ExitCode& exit_code) {
  CLI::App* report = app.add_subcommand("report", "A run or a flight as one page for the browser");
  auto options = std::make_shared<Options>();
  report->add_option("folder", options->folder, "Of 'adit fly --out' or 'adit run --out'")
      ->required()
      ->type_name("RUN_DIR");
  report->add_option("-o,--out", options->out, "The page (RUN_DIR/report.html)")->type_name("FILE.html");
  report->add_flag("--quiet", options->quiet, "No progress, no notes");
  report->footer("Example: adit report flight");
  report->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
