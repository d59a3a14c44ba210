// `adit run`: frames in, a table of headings out, and pictures for people.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "adit/io/frame_source.hpp"
#include "adit/io/lamp_file.hpp"
#include "adit/io/output_file.hpp"
#include "bag_inputs.hpp"
#include "finder_options.hpp"
#include "frame_line.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "report_run.hpp"
#include "run_outputs.hpp"
#include "run_shard.hpp"
#include "subcommands.hpp"
#include "tally.hpp"

namespace adit::tools {
namespace {

struct RunOptions {
  std::vector<std::string> inputs;
  FinderOptions finder;
  OutputOptions outputs;
  io::SourceOptions sources;
  std::string bag_topic;  ///< of the images in bags; "": the only one
  int jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  std::int64_t limit = 0;  ///< 0: none
  Shard shard;
  bool flash = false;
  std::string learn_lamp;  ///< file; empty: none
  bool quiet = false;
};

using Sources = std::vector<std::unique_ptr<io::FrameSource>>;

/// Frames of all sources, where all know theirs.
std::optional<std::int64_t> total_of(const Sources& sources, std::int64_t limit) {
  std::int64_t total = 0;
  for (const auto& source : sources) {
    const auto count = source->frame_count();
    if (!count) return limit > 0 ? std::optional(limit) : std::nullopt;
    total += *count;
  }
  return limit > 0 ? std::min(total, limit) : total;
}

bool table_on_terminal(const OutputOptions& outputs) {
  const bool on_stdout =
      outputs.csv == "-" || outputs.jsonl == "-" ||
      (outputs.csv.empty() && outputs.jsonl.empty() && outputs.report.empty() && !outputs.wants_pictures());
  return on_stdout && ::isatty(STDOUT_FILENO) == 1;
}

/// One run from the first frame to the last.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        settings_(line_settings()),
        sources_(sources_of(options.inputs, options.sources, options.bag_topic)),
        total_(options.shard.is_given() ? std::nullopt : total_of(sources_, options.limit)),
        output_options_(labelled_outputs()),
        outputs_(output_options_, sources_.front()->rate_hz()),
        progress_(total_, "frames", options.quiet || table_on_terminal(options.outputs)),
        report_(report_of(options, settings_)),
        line_(
            settings_, [this](FrameWork& work) { take_judged(work); }, [this](FrameWork& work) { take_drawn(work); }) {}

  ExitCode operator()() {
    for (const auto& source : sources_) {
      if (!take_source(*source)) break;
    }
    line_.finish();
    const bool lamp_is_missing = !options_.learn_lamp.empty() && !write_lamp();
    progress_.clear();
    const ExitCode code = end();
    return code == kSuccess && lamp_is_missing ? kOutputNotWritten : code;
  }

 private:
  LineSettings line_settings() const {
    LineSettings settings;
    settings.configuration = configuration_of(options_.finder);
    settings.camera = camera_of_inputs(options_.finder, options_.inputs, options_.bag_topic);
    settings.jobs = options_.jobs;
    settings.flash = options_.flash;
    settings.learn_lamp = !options_.learn_lamp.empty();
    if (!options_.finder.lamp_file.empty()) settings.lamp = lamp_of(options_.finder);
    settings.wants_panel = !options_.outputs.video.empty();
    settings.wants_png = !options_.outputs.frames_folder.empty();
    return settings;
  }

  /// None when none is asked for. Tells the line which frames it wants pictures of.
  static std::unique_ptr<RunReport> report_of(const RunOptions& options, LineSettings& settings) {
    if (options.outputs.report.empty()) return nullptr;
    auto report = std::make_unique<RunReport>(options.inputs, settings.configuration);
    settings.wants_shot = [wanted = report.get()](std::int64_t row) { return wanted->wants(row); };
    return report;
  }

  OutputOptions labelled_outputs() const {
    OutputOptions outputs = options_.outputs;
    if (options_.shard.is_given())
      outputs.part =
          run_label(options_.shard, options_.inputs, sources_of(options_.inputs, options_.sources, options_.bag_topic),
                    options_.sources.images_hz, settings_);
    return outputs;
  }

  /// Is the next item (run_shard.hpp) in this shard?
  bool is_next_item_ours() {
    return !output_options_.part || options_.shard.has(next_item_++, output_options_.part->items);
  }

  /// False when the run is to end.
  bool take_source(io::FrameSource& source) {
    if (source.is_sequence() && !is_next_item_ours()) return true;
    line_.begin_source(source.is_sequence());
    while (!is_interrupted() && (options_.limit == 0 || pushed_ < options_.limit)) {
      std::optional<io::Frame> frame = source.next();
      if (!frame) {
        if (!source.fault().empty()) {
          early_ends_.push_back(source.fault());
          progress_.say("adit: " + source.fault());
        }
        return true;
      }
      if (!source.is_sequence() && !is_next_item_ours()) continue;
      line_.push(std::move(*frame));
      ++pushed_;
    }
    return false;
  }

  void take_judged(FrameWork& work) {
    if (work.open_space) {
      tally_.add(work.open_space->status);
      if (!work.why.empty() && !mismatch_told_) {
        mismatch_told_ = true;
        progress_.say("adit: " + work.frame.source + ": " + work.why + " (told once; see the column message)");
      }
      if (!work.doubt.empty() && !doubt_told_ && !options_.quiet) {
        doubt_told_ = true;
        progress_.say("adit: " + work.frame.source + ": " + work.doubt + " (told once)");
      }
    } else {
      tally_.add_unreadable();
      progress_.say("adit: " + work.why);
    }
    if (tally_.judged() > 0) outputs_.release();
    const io::TableRow row{work.frame.source, work.frame.index, work.frame.stamp_s, work.open_space,
                           work.command,      work.why,         work.track};
    outputs_.write_row(row);
    if (report_) report_->add_row(row);
    progress_.show(tally_.frames());
  }

  void take_drawn(FrameWork& work) {
    if (!work.png.empty()) outputs_.write_frame(work.number, work.frame.source, work.png);
    if (!work.panel.empty()) outputs_.write_video(work.panel);
    if (work.shot) report_->add_shot(work.number, work.frame.pixels.size(), std::move(*work.shot));
  }

  ExitCode end() {
    const bool interrupted = is_interrupted();
    if (options_.shard.is_given()) return end_shard();
    const ExitCode code = tally_.exit_code();
    // A run that judged nothing leaves nothing behind; why has been said.
    if (interrupted || tally_.judged() > 0) leave_outputs();
    if (!options_.quiet && tally_.frames() > 1) print_summary();
    if (interrupted) {
      print_line("adit: interrupted after " + std::to_string(tally_.frames()) +
                 (total_ ? " of " + std::to_string(*total_) : std::string()) + " frames; what was written is whole");
      return kInterrupted;
    }
    return code == kSuccess && !early_ends_.empty() ? kSomeUnreadable : code;
  }

  void leave_outputs() {
    outputs_.commit();
    const OutputOptions& wanted = options_.outputs;
    if (!wanted.folder.empty()) write_run_origin(wanted.folder, settings_.configuration, options_.finder.camera_file);
    if (report_) report_->write(wanted.report);
  }

  /// A part is there when it is whole; one without a readable frame is a part too.
  ExitCode end_shard() {
    if (is_interrupted()) {
      print_line("adit: interrupted; half a part is none, run --shard " + options_.shard.text() + " again");
      return kInterrupted;
    }
    outputs_.commit();
    if (!options_.quiet) print_summary();
    return tally_.judged() < tally_.frames() || !early_ends_.empty() ? kSomeUnreadable : kSuccess;
  }

  /// False when there is nothing to write.
  bool write_lamp() {
    const LampPattern lamp = line_.lamp();
    if (lamp.frames > 0.0) {
      io::write_file(options_.learn_lamp, io::to_yaml(lamp));
      return true;
    }
    progress_.say(
        "adit: " + options_.learn_lamp +
        ": not written: no frame of a sequence showed the lamp's light; give a video, or images with --sequence");
    return false;
  }

  void print_summary() const {
    const double seconds = progress_.elapsed_s();
    char pace[64];
    std::snprintf(pace, sizeof pace, "; %.1f s, %.1f frames a second", seconds,
                  static_cast<double>(tally_.frames()) / std::max(seconds, 1e-9));
    print_line(tally_.text() + pace);
  }

  const RunOptions& options_;
  LineSettings settings_;
  Sources sources_;
  std::optional<std::int64_t> total_;
  OutputOptions output_options_;
  RunOutputs outputs_;
  Progress progress_;
  Tally tally_;
  std::vector<std::string> early_ends_;
  std::int64_t pushed_ = 0;
  std::int64_t next_item_ = 0;
  bool mismatch_told_ = false;
  bool doubt_told_ = false;
  std::unique_ptr<RunReport> report_;
  FrameLine line_;  ///< last: it calls back into the others
};

void add_options(CLI::App& run, RunOptions& options) {
  run.add_option("input", options.inputs, "Images, folders, patterns, videos, .bag, /dev/videoN")
      ->required()
      ->type_name("INPUT...");
  run.add_option("--csv", options.outputs.csv, "Table as CSV; - is standard output (the default)")->type_name("FILE");
  run.add_option("--jsonl", options.outputs.jsonl, "Table as JSON Lines; - is standard output")->type_name("FILE");
  run.add_option("--video", options.outputs.video, "Frame and depth map side by side: .mp4, .mkv, .avi")
      ->type_name("FILE");
  run.add_option("--frames", options.outputs.frames_folder, "A PNG of each frame with its opening")->type_name("DIR");
  run.add_option("--out", options.outputs.folder, "Folder for headings.csv and settings.yaml, as adit report takes it")
      ->type_name("DIR");
  run.add_option("--report", options.outputs.report, "The run as one page for the browser")->type_name("FILE.html");
  add_finder_options(run, options.finder);
  run.add_option("--fps", options.sources.images_hz, "Frames a second of images: their stamps (30)")
      ->type_name("HZ")
      ->check(NumberIn(0.001, 10000.0));
  run.add_option("--topic", options.bag_topic, "Of the images in a bag (the only one)")->type_name("NAME");
  run.add_flag("--sequence", options.sources.images_are_sequence,
               "Images follow each other in time: steering remembers");
  run.add_flag("--flash", options.flash, "The lamp is on and off in turns: judge each frame with the one before");
  add_lamp_option(run, options.finder);
  run.add_option("--learn-lamp", options.learn_lamp, "Learn the lamp's pattern from sequences")->type_name("FILE.yaml");
  run.add_option("--jobs", options.jobs, "Threads; the output is the same with any (all cores)")
      ->type_name("N")
      ->check(NumberIn(1, 256));
  run.add_option("--limit", options.limit, "End after so many frames")
      ->type_name("N")
      ->check(NumberIn(std::int64_t{1}, std::int64_t{1} << 40));
  add_shard_option(run, options.shard);
  run.add_flag("--timing", options.outputs.timing, "A column find_ms");
  run.add_flag("--quiet", options.quiet, "No progress, no summary");
}

/// Nothing that is read may be written over. @throws CLI::ValidationError
void check_files(RunOptions& options) {
  FileUses uses;
  uses.reads_frames("INPUT", options.inputs);
  uses.reads(options.finder);
  check_outputs(options.outputs, uses);
  uses.writes("--learn-lamp", options.learn_lamp);
}

}  // namespace

void add_run(CLI::App& app, ExitCode& exit_code) {
  CLI::App* run = app.add_subcommand("run", "Find the open space in images, folders, videos or a camera");
  auto options = std::make_shared<RunOptions>();
  add_options(*run, *options);
  run->footer("Example: adit run data/clip.avi --csv headings.csv --video headings.mp4");
  run->callback([options, &exit_code] {
    check_files(*options);
    if (options->shard.is_given() && !options->learn_lamp.empty()) {
      throw CLI::ValidationError("--learn-lamp", "a shard sees only its part; learn from the whole sequence");
    }
    check_shard(options->shard, options->outputs, options->inputs, options->limit);
    watch_signals();
    make_run_folder(options->outputs);
    exit_code = Run(*options)();
  });
}

}  // namespace adit::tools
