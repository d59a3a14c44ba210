// `adit render`: frames of a course or a world with truth, as a data set.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "render_work.hpp"
#include "subcommands.hpp"
#include "world_options.hpp"

namespace adit::tools {
namespace {

constexpr int kSideLeast_px = 16, kSideMost_px = 4096;  ///< as lens.width and lens.height take them
constexpr std::int64_t kFrames = 100;                   ///< where neither --frames nor --poses says how many

struct Options {
  FlyOptions fly;
  RenderWork work;
  std::string size;
  std::string poses;
};

void add_picture_options(CLI::App& render, FlyOptions& options, std::string& size) {
  std::string rigs;
  for (const std::string& name : sim::rig_preset_names()) rigs += (rigs.empty() ? "" : ", ") + name;
  render.add_option("--rig", options.lamp, "Lamp and camera: " + rigs)
      ->type_name("PRESET")
      ->check(CLI::IsMember(sim::rig_preset_names()));
  render.add_option("--dust", options.dust_1_m, "Extinction, 0 to 0.5 1/m")
      ->type_name("1/M")
      ->check(NumberIn(0.0, 0.5));
  render.add_option("--size", size, "Of the frames (640x480)")->type_name("WxH");
  render.add_option("--config", options.config_file, "Settings by section, such as DIR/settings.yaml of before")
      ->type_name("FILE.yaml");
  render.add_option("--set", options.settings, "One setting, over those of --config; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_work_options(CLI::App& render, Options& options) {
  render.add_option("--frames", options.work.frames, "How many (100; with --poses: a frame a row)")
      ->type_name("N")
      ->check(NumberIn(1, 1000000));
  render.add_option("--seed", options.work.seed, "Of places and noise (1)")->type_name("N");
  render.add_option("--poses", options.poses, "From these places, such as a flight's flight.csv; else drawn")
      ->type_name("FILE");
  render.add_option("--out", options.work.out, "Folder: frames, range, truth.csv, camera.yaml, settings.yaml")
      ->type_name("DIR")
      ->required();
  render.add_option("--jobs", options.work.jobs, "Frames at once (all cores)")->type_name("N")->check(NumberIn(1, 256));
  render.add_flag("--quiet", options.work.quiet, "No progress, no summary");
}

/// "320x240" as two settings.
void take_size(const std::string& size, std::vector<std::string>& settings) {
  int width = 0, height = 0, read = 0;
  if (std::sscanf(size.c_str(), "%dx%d%n", &width, &height, &read) != 2 ||
      static_cast<std::size_t>(read) != size.size() || std::min(width, height) < kSideLeast_px ||
      std::max(width, height) > kSideMost_px)
    throw CLI::ValidationError("--size", "'" + size + "' is not WIDTHxHEIGHT with sides of 16 to 4096 px");
  settings.insert(settings.begin(), {"lens.width=" + std::to_string(width), "lens.height=" + std::to_string(height)});
}

/// A cell of a table.
std::string cell_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; }, '_');
  return text;
}

/// What of the sections makes a data set.
io::Settings rendered_sections(FlySettings& settings, sim::ViewpointConfig& viewpoints, bool with_course) {
  io::Settings all = sections_of(settings);
  all.add("viewpoint", viewpoints);
  io::Settings some;
  for (const char* name : {"viewpoint", "truth", "lamp", "lamps", "lens", "sensor", "dust", "dirt", "render", "course"})
    for (const io::SettingSection& section : all.sections())
      if (section.name == name && (with_course || section.name != "course")) some.add(section);
  return some;
}

ExitCode run(Options& options) {
  FlyOptions& fly = options.fly;
  RenderWork& work = options.work;
  if (fly.course.empty() == fly.world_file.empty()) throw CLI::RequiredError("one of COURSE and --world");
  if (!options.size.empty()) take_size(options.size, fly.settings);
  FileUses uses;
  add_reads(fly, uses);
  uses.reads("--poses", options.poses);
  uses.writes_into("--out", work.out, {"truth.csv", "camera.yaml", "settings.yaml", "dataset.json"});
  watch_signals();
  sim::ViewpointConfig viewpoints;
  FlySettings settings = fly_settings_of(fly, [&](io::Settings& all) { all.add("viewpoint", viewpoints); });
  if (!options.poses.empty()) work.poses = read_poses(options.poses);
  if (work.frames == 0) work.frames = work.poses.empty() ? kFrames : static_cast<std::int64_t>(work.poses.size());
  if (!work.poses.empty()) work.frames = std::min(work.frames, static_cast<std::int64_t>(work.poses.size()));
  const std::string place = fly.course.empty() ? fly.world_file : fly.course;
  work.note = {cell_of(std::filesystem::path(place).stem().string()),
               settings.rig.name,
               work.seed,
               static_cast<double>(settings.rig.dust.extinction_1_m),
               settings.rig.lens.width,
               settings.rig.lens.height,
               work.frames,
               false};
  FlyOptions bare = fly;
  bare.settings.clear();
  bare.config_file.clear();
  bare.dust_1_m = -1.0;
  FlySettings as_rig = fly_settings_of(bare);
  sim::ViewpointConfig bare_viewpoints;
  const bool with_course = !fly.course.empty();
  work.settings_yaml = remake_yaml(
      rendered_sections(settings, viewpoints, with_course), rendered_sections(as_rig, bare_viewpoints, with_course),
      "adit render " + (with_course ? "" : std::string("--world ")) + cell_of(place) + " --rig " + settings.rig.name +
          " --frames " + std::to_string(work.frames) + " --seed " + std::to_string(work.seed) +
          (options.poses.empty() ? "" : " --poses " + cell_of(options.poses)) + " --config settings.yaml --out again");
  const Site site = site_of(fly, settings);
  for (const std::string& note : site.world.notes)
    if (!work.quiet) print_line("adit: " + note);
  return render_frames(work, settings, viewpoints, site);
}

}  // namespace

void add_render(CLI::App& app, ExitCode& exit_code) {
  CLI::App* render = app.add_subcommand("render", "Frames of a simulated tunnel with truth, as a data set");
  auto options = std::make_shared<Options>();
  options->work.jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  add_world_options(*render, options->fly);
  add_picture_options(*render, options->fly, options->size);
  add_work_options(*render, *options);
  render->footer("Example: adit render s_bend --frames 8 --rig narrow_beam --out frames");
  render->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
