// `adit fly`: the robot flies a course or a world, closed loop, on what it sees.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>
#include <thread>

#include "adit/io/errors.hpp"
#include "fly_parts.hpp"
#include "fly_runs.hpp"
#include "fly_setup.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "subcommands.hpp"
#include "world_options.hpp"

namespace adit::tools {
namespace {

struct Options {
  FlyOptions fly;
  FlyWork work;
  std::uint64_t seed = 1;
  int runs = 0;
  std::string seeds;
  Shard shard;
};

/// "3..17"
std::vector<std::uint64_t> seeds_of(const Options& options) {
  std::uint64_t first = options.seed, last = options.seed;
  if (!options.seeds.empty()) {
    unsigned long long a = 0, b = 0;
    int read = 0;
    if (std::sscanf(options.seeds.c_str(), "%llu..%llu%n", &a, &b, &read) != 2 ||
        static_cast<std::size_t>(read) != options.seeds.size() || b < a || b - a >= 100000)
      throw CLI::ValidationError("--seeds", "'" + options.seeds + "' is not A..B with A <= B, 100000 at the most");
    first = a;
    last = b;
  } else if (options.runs > 0) {
    last = first + static_cast<std::uint64_t>(options.runs) - 1;
  }
  std::vector<std::uint64_t> seeds(last - first + 1);
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

void add_flight_options(CLI::App& fly, Options& options) {
  std::string lamps;
  for (const std::string& name : sim::rig_preset_names()) lamps += (lamps.empty() ? "" : ", ") + name;
  fly.add_option("--lamp", options.fly.lamp, "Lamp and camera: " + lamps)
      ->type_name("PRESET")
      ->check(CLI::IsMember(sim::rig_preset_names()));
  fly.add_option("--dust", options.fly.dust_1_m, "Extinction, 0 to 0.5 1/m")
      ->type_name("1/M")
      ->check(NumberIn(0.0, 0.5));
  fly.add_option("--speed", options.fly.speed_m_s, "Forward speed (1)")->type_name("M/S")->check(NumberIn(0.05, 10.0));
  fly.add_option("--time", options.fly.time_s, "At the most (120)")->type_name("S")->check(NumberIn(0.1, 36000.0));
  fly.add_option("--method", options.fly.method, "Chain of stages: paper, adit")
      ->type_name("NAME")
      ->check(CLI::IsMember({"paper", "adit"}));
  fly.add_option("--prefer", options.fly.prefer, "At junctions, not with paper: straight, left, right, explore")
      ->type_name("WAY")
      ->check(CLI::IsMember({"straight", "left", "right", "explore"}));
  fly.add_option("--config", options.fly.config_file, "Settings by section; see docs/simulation.md")
      ->type_name("FILE.yaml");
  fly.add_option("--set", options.fly.settings, "One setting, over those of --config; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

/// The page holds 36 lines: what is seldom wanted stands in the manual alone, and its names in the last lines.
void add_work_options(CLI::App& fly, Options& options) {
  fly.add_option("--out", options.work.out, "Folder for flight.csv, summary.json, map.png, figures")->type_name("DIR");
  fly.add_flag("--video", options.work.film, "Also the film, with overlay: flight.mp4");
  fly.add_option("--report", options.work.report, "The flight as one page for the browser")->type_name("FILE.html");
#ifdef ADIT_WITH_HTTP
  fly.add_flag("--view", options.work.view, "Watch it in a page while it is flown; ends with Ctrl-C");
  fly.add_option("--listen", options.work.view_host, "Address of that page (127.0.0.1)")
      ->type_name("ADDRESS")
      ->group("");
  fly.add_option("--port", options.work.view_port, "Its port (any that is free)")
      ->type_name("N")
      ->check(NumberIn(1, 65535))
      ->group("");
#endif
  fly.add_option("--still", options.work.stills_s, "Also the picture at this time, repeatable")
      ->type_name("S")
      ->allow_extra_args(false)
      ->check(NumberIn(0.0, 36000.0))
      ->group("");
  fly.add_option("--bag", options.work.bag.file, "The flight as a bag of ROS 1")->type_name("FILE.bag")->group("");
  fly.add_option("--bag-images", options.work.bag.images, "raw or jpeg (raw)")
      ->type_name("KIND")
      ->check(CLI::IsMember({"raw", "jpeg"}))
      ->group("");
  fly.add_option("--bag-topic", options.work.bag.topic, "Of the images (camera/image_raw)")
      ->type_name("NAME")
      ->group("");
  fly.add_flag("--sensors", options.work.sensors, "Also imu.csv and scans.csv")->group("");
  fly.add_option("--seed", options.seed, "Of start, gusts and noise (1)")->type_name("N");
  fly.add_option("--runs", options.runs, "Fly with so many seeds; a table and the success rate")
      ->type_name("N")
      ->check(NumberIn(1, 100000));
  fly.add_option("--seeds", options.seeds, "The same with these seeds")->type_name("A..B");
  add_shard_option(fly, options.shard, true);
  fly.add_option("--jobs", options.work.jobs, "Flights at once (all cores)")
      ->type_name("N")
      ->check(NumberIn(1, 256))
      ->group("");
  fly.add_flag("--quiet", options.work.quiet, "No progress, no summary")->group("");
}

/// Of the seeds, those of the shard are flown.
void take_shard(Options& options, const FlySettings& settings, const Site& site) {
  if (options.runs == 0 && options.seeds.empty()) throw CLI::RequiredError("--runs or --seeds (for --shard)");
  if (options.work.out.empty()) throw CLI::RequiredError("--out (for --shard)");
  std::vector<std::uint64_t>& seeds = options.work.seeds;
  options.work.part = fly_label(options.shard, seeds, settings, options.fly, site);
  const auto items = static_cast<std::int64_t>(seeds.size());
  seeds =
      std::vector<std::uint64_t>(seeds.begin() + options.shard.first(items), seeds.begin() + options.shard.end(items));
}

/// Nothing that is read may be written over. @throws CLI::ValidationError
void check_files(const Options& options) {
  FileUses uses;
  add_reads(options.fly, uses);
  uses.writes_into("--out", options.work.out, {"settings.yaml", "map.yaml", "flight.csv"});
  uses.writes("--out", options.work.out);
  uses.writes("--report", options.work.report);
  uses.writes("--bag", options.work.bag.file);
}

ExitCode run(Options& options) {
  if (options.fly.course.empty() == options.fly.world_file.empty())
    throw CLI::RequiredError("one of COURSE and --world");
  if (options.work.out.empty() && (options.work.film || options.work.sensors || !options.work.stills_s.empty()))
    throw CLI::RequiredError("--out (for --video, --still and --sensors)");
  if (!options.work.bag.file.empty() && (options.runs > 0 || !options.seeds.empty()))
    throw CLI::ValidationError("--bag", "is for one flight");
  options.work.seeds = seeds_of(options);
  options.work.name =
      std::filesystem::path(options.fly.course.empty() ? options.fly.world_file : options.fly.course).stem().string();
  if (!options.work.report.empty() && (options.runs > 0 || !options.seeds.empty()))
    throw CLI::ValidationError("--report", "is for one flight; of many, give --out and report each seed's folder");
  if (options.work.view && (options.runs > 0 || !options.seeds.empty()))
    throw CLI::ValidationError("--view", "is for one flight");
  check_files(options);
  watch_signals();
  const FlySettings settings = fly_settings_of(options.fly);
  const Site site = site_of(options.fly, settings);
  for (const std::string& note : site.world.notes)
    if (!options.work.quiet) print_line("adit: " + note);
  const bool many = options.runs > 0 || !options.seeds.empty();
  if (options.shard.is_given()) take_shard(options, settings, site);
  return many ? fly_many(options.work, settings, site) : fly_once(options.work, settings, site);
}

}  // namespace

void add_fly(CLI::App& app, ExitCode& exit_code) {
  CLI::App* fly = app.add_subcommand("fly", "Fly a tunnel in simulation on what the camera shows");
  auto options = std::make_shared<Options>();
  options->work.jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  add_world_options(*fly, options->fly);
  add_flight_options(*fly, *options);
  add_work_options(*fly, *options);
  fly->footer(
      "More, in docs/manual.md: --jobs --still --sensors --bag --bag-images --bag-topic --shard --listen\n"
      "--port --quiet\nExample: adit fly s_bend --out flight --video");
  fly->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
