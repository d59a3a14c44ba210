// `adit eval`: methods judged on frames whose openings are known.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "eval_gallery.hpp"
#include "eval_parts.hpp"
#include "eval_report.hpp"
#include "eval_work.hpp"
#include "file_uses.hpp"
#include "finder_options.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

struct Options {
  std::vector<std::string> sets;
  std::vector<std::string> methods;
  std::vector<std::string> tables;
  FinderOptions finder;
  std::string csv, json, gallery, report;
  EvalWork work;
  bool sequence = false;
  bool no_baselines = false;
};

void add_options(CLI::App& eval, Options& options) {
  eval.add_option("dataset", options.sets, "Folders with openings.json or with truth.csv of 'adit render'")
      ->required()
      ->type_name("DATASET...");
  std::string known;
  for (const std::string& name : known_methods()) known += (known.empty() ? "" : ",") + name;
  eval.add_option("--method", options.methods, "Methods to judge (" + known + ")")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  eval.add_option("--table", options.tables, "A method by its answers, columns as of run --csv; repeatable")
      ->type_name("NAME=FILE")
      ->allow_extra_args(false);
  eval.add_flag("--no-baselines", options.no_baselines, "Leave out centre, random, darkest pixel, paper's K");
  add_configuration_options(eval, options.finder);
  eval.add_option("--camera", options.finder.camera_file, "Calibration, for sets without a camera.yaml")
      ->type_name("FILE.yaml");
  add_lamp_option(eval, options.finder);
  eval.add_flag("--sequence", options.sequence, "Frames of a place follow each other in time: jitter");
  eval.add_option("--csv", options.csv, "Figures as CSV; - is standard output, instead of the text")->type_name("FILE");
  eval.add_option("--json", options.json, "Figures and all answers as JSON")->type_name("FILE");
  eval.add_option("--gallery", options.gallery, "Every frame and answer: one NAME.html, or a folder")
      ->type_name("PATH");
  eval.add_option("--report", options.report, "The same, always one page")
      ->type_name("FILE.html")
      ->check([](const std::string& path) {
        return path.ends_with(".html") ? std::string() : "'" + path + "' does not end in .html";
      });
  eval.add_option("--seed", options.work.bootstrap.seed, "Of intervals and random places (1)")->type_name("N");
  eval.add_option("--resamples", options.work.bootstrap.resamples, "Draws of places for the intervals (2000)")
      ->type_name("N")
      ->check(NumberIn(100, 1000000));
  eval.add_option("--jobs", options.work.jobs, "Threads; the output is the same with any (all cores)")
      ->type_name("N")
      ->check(NumberIn(1, 256));
  add_shard_option(eval, options.work.shard);
  eval.add_flag("--quiet", options.work.quiet, "No progress");
}

/// Is the baseline paper_k10 what --method paper is anyway?
bool judges_published(const Options& options, const FinderConfig& config) {
  const std::string paper(to_string(Method::kPaper));
  const auto& methods = options.methods;
  return config.cluster_count == kPublishedK && config.clustering == Clustering::kExact &&
         (methods.empty() || std::find(methods.begin(), methods.end(), paper) != methods.end());
}

/// The methods of --method, the tables, the baselines; no name twice.
std::vector<Contender> contenders_of(const Options& options, const FinderConfig& config) {
  const std::vector<std::string> known = known_methods();
  const LampPattern lamp = lamp_of(options.finder);
  std::vector<Contender> all;
  for (const std::string& name : options.methods.empty() ? known : options.methods) {
    FinderConfig one = config;
    if (!parse(name, one.method)) {
      std::string list;
      for (const std::string& k : known) list += (list.empty() ? "" : ", ") + k;
      throw CLI::ValidationError("--method", "'" + name + "' is not known; known are: " + list);
    }
    all.push_back(finder_contender(name, one, lamp));
  }
  for (const std::string& table : options.tables) {
    const std::size_t at = table.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == table.size())
      throw CLI::ValidationError("--table", "'" + table + "' is not NAME=FILE.csv");
    all.push_back(table_contender(table.substr(0, at), table.substr(at + 1)));
  }
  if (!options.no_baselines) {
    const bool as_published = judges_published(options, config);
    for (Contender& baseline : baselines(config, options.work.bootstrap.seed))
      if (!(as_published && baseline.name == kPublishedName)) all.push_back(std::move(baseline));
  }
  std::set<std::string> names;
  for (const Contender& c : all)
    if (c.scanned_k == 0 && !names.insert(c.name).second)
      throw CLI::ValidationError("--table", "'" + c.name + "' is the name of another method too; choose another");
  return all;
}

/// The part lies beside the file that the figures will stand in.
const std::string& whole_of(const Options& options) {
  if (!options.gallery.empty() || !options.report.empty())
    throw CLI::ValidationError("--shard", "a gallery shows the whole; leave out --gallery and --report");
  const std::string& whole = options.json.empty() ? options.csv : options.json;
  if (whole.empty() || whole == "-") throw CLI::RequiredError("--json FILE or --csv FILE (for --shard)");
  return whole;
}

/// Nothing that is read may be written over. @throws CLI::ValidationError
void check_files(const Options& options, const std::string& whole) {
  namespace fs = std::filesystem;
  FileUses uses;
  uses.reads(options.finder);
  for (const std::string& table : options.tables) uses.reads("--table", table.substr(table.find('=') + 1));
  for (const Part& part : options.work.parts) uses.reads("PART", part.path);
  uses.reads_frames("DATASET", options.sets);
  for (std::size_t s = 0; s < options.sets.size(); ++s) {
    std::set<fs::path> folders{options.sets[s]};
    for (const EvalFrame& frame : options.work.sets[s].frames) {
      uses.reads("DATASET", frame.image);
      uses.reads("DATASET", frame.ranges);
      folders.insert(frame.image.parent_path());
      folders.insert(frame.image.parent_path().parent_path());
    }
    for (const fs::path& folder : folders)
      for (const char* name : {"openings.json", "truth.csv", "camera.yaml"}) uses.reads("DATASET", folder / name);
  }
  if (!whole.empty()) return uses.writes("--shard", part_path(whole, options.work.shard));
  uses.writes("--json", options.json);
  uses.writes("--csv", options.csv);
  for (const auto& [name, path] : {std::pair("--gallery", options.gallery), std::pair("--report", options.report)}) {
    if (!path.ends_with(".html")) uses.writes_into(name, path, {});
    uses.writes(name, path);
  }
}

ExitCode run(Options& options, const std::vector<std::string>& arguments) {
  const std::string whole = options.work.shard.is_given() ? whole_of(options) : "";
  EvalWork& work = options.work;
  watch_signals();
  const io::Configuration configuration = configuration_of(options.finder);
  work.finder = configuration.finder;
  if (const auto camera = camera_of(options.finder)) work.camera = camera->model();
  work.contenders = contenders_of(options, configuration.finder);
  for (const std::string& path : options.sets) work.sets.push_back(read_eval_set(path, options.sequence));
  work.pictures = !options.gallery.empty() || !options.report.empty();
  check_files(options, whole);
  const EvalResult result = evaluate(work);
  if (result.interrupted) {
    print_line("adit: interrupted; figures of a part would mislead, so none are written");
    return kInterrupted;
  }
  if (work.shard.is_given()) {
    write_eval_part(whole, eval_label(work, arguments), work, result);
    return result.unreadable > 0 ? kSomeUnreadable : kSuccess;
  }
  if (!options.json.empty()) io::write_file(options.json, eval_json(work, result));
  if (!options.csv.empty() && options.csv != "-") io::write_file(options.csv, eval_csv(work, result));
  const ReportOrigin origin = origin_now(io::to_yaml(configuration), io::to_yaml({}));
  for (const std::string* path : {&options.gallery, &options.report})
    if (!path->empty()) write_gallery(*path, work, result, origin);
  const std::string text = options.csv == "-" ? eval_csv(work, result) : eval_text(work, result);
  io::OutputFile out("-");
  out.write(text);
  out.commit();
  return result.unreadable > 0 ? kSomeUnreadable : kSuccess;
}

}  // namespace

void add_eval(CLI::App& app, ExitCode& exit_code) {
  CLI::App* eval = app.add_subcommand("eval", "Judge methods on frames whose openings are known");
  auto options = std::make_shared<Options>();
  options->work.jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  add_options(*eval, *options);
  eval->footer("Example: adit eval data --json figures.json");
  eval->callback([eval, options, &exit_code] { exit_code = run(*options, arguments_of(*eval)); });
}

ExitCode eval_from_parts(const std::vector<Part>& parts) {
  CLI::App eval("eval");
  Options options;
  add_options(eval, options);
  std::vector<std::string> arguments = nlohmann::json::parse(parts.front().label.head);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  eval.parse(arguments);
  options.work.parts = parts;
  options.work.jobs = 1;
  return run(options, {});
}

}  // namespace adit::tools
