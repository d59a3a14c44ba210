// `adit merge`: the parts that --shard made, joined to what one machine would have written.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "eval_parts.hpp"
#include "file_uses.hpp"
#include "parts.hpp"
#include "progress.hpp"
#include "subcommands.hpp"
#ifdef ADIT_WITH_SIM
#include "fly_parts.hpp"
#endif

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string whole;
  std::vector<std::string> parts;
  bool remove = false;
  bool missing = false;
  bool quiet = false;
};

void join_tables(const fs::path& whole, const std::vector<Part>& parts) {
  io::OutputFile file(whole);
  file.write(parts.front().label.head);
  for (const Part& part : parts) part.read([&file](std::string_view text) { file.write(text); });
  file.commit();
}

ExitCode join([[maybe_unused]] const Options& options, const fs::path& whole, const std::vector<Part>& parts) {
  const std::string& command = parts.front().label.command;
  if (command == "run") {
    join_tables(whole, parts);
    return kSuccess;
  }
  if (command == "eval") return eval_from_parts(parts);
#ifdef ADIT_WITH_SIM
  if (command == "fly") {
    join_flights(options.whole, parts, options.quiet);
    return kSuccess;
  }
#endif
  throw io::InputError(parts.front().path.string() + ": this adit cannot join parts of 'adit " + command + "'");
}

/// "3,7", as `sbatch --array` takes it.
void print_missing(const std::vector<fs::path>& paths) {
  std::string line;
  for (const int index : missing_parts(paths)) line.append(line.empty() ? "" : ",").append(std::to_string(index));
  io::OutputFile out("-");
  out.write(line + "\n");
  out.commit();
}

ExitCode run(const Options& options) {
  // The flights of a campaign lie in a folder, and so do their parts.
  const fs::path whole = fs::is_directory(options.whole) ? fs::path(options.whole) / "runs" : fs::path(options.whole);
  std::vector<fs::path> paths(options.parts.begin(), options.parts.end());
  if (paths.empty()) paths = parts_beside(whole);
  if (paths.empty()) throw io::InputError(whole.string() + ".part-*: no parts of it are there");
  if (options.missing) {
    print_missing(paths);
    return kSuccess;
  }
  FileUses uses;
  for (const fs::path& path : paths) uses.reads("PART", path);
  uses.writes("WHOLE", whole);
  const std::vector<Part> parts = read_parts(paths);
  const ExitCode code = join(options, whole, parts);
  if (options.remove)
    for (const Part& part : parts) fs::remove(part.path);
  if (!options.quiet)
    print_line("joined " + std::to_string(parts.size()) + (parts.size() == 1 ? " part, " : " parts, ") +
               std::to_string(parts.front().label.items) + " items");
  return code;
}

}  // namespace

void add_merge(CLI::App& app, ExitCode& exit_code) {
  CLI::App* merge = app.add_subcommand("merge", "Join what --shard of run, eval and fly made in parts");
  auto options = std::make_shared<Options>();
  merge->add_option("whole", options->whole, "The --csv, --jsonl, --json FILE or --out DIR that was given")
      ->required()
      ->type_name("WHOLE");
  merge->add_option("part", options->parts, "Its parts, where they are not beside it as WHOLE.part-I-of-N")
      ->type_name("PART...");
  merge->add_flag("--missing", options->missing, "Join nothing; print the numbers of the parts that are missing");
  merge->add_flag("--remove", options->remove, "Remove the parts once they are joined");
  merge->add_flag("--quiet", options->quiet, "No summary");
  merge->footer("Example: adit merge headings.csv");
  merge->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
