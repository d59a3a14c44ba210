// `adit gz`: Gazebo's camera in, Gazebo's velocity command out, with no ROS between.
#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "adit/io/table.hpp"
#include "adit/node/control.hpp"
#include "adit/node/perception.hpp"
#include "adit/node/settings.hpp"
#include "file_uses.hpp"
#include "finder_options.hpp"
#include "gz_link.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

using Steady = std::chrono::steady_clock;

constexpr auto kTick = std::chrono::milliseconds(50);
constexpr auto kReport = std::chrono::seconds(5);

struct Options {
  FinderOptions finder;
  GzTopics topics;
  std::string pilot = "by_method";
  double speed_m_s = node::PerceptionConfig().speed_m_s;
  bool is_recorded = false;
  std::string csv;
  std::int64_t limit = 0;
  bool quiet = false;
};

node::PerceptionSettings settings_of(const Options& options) {
  node::PerceptionSettings settings;
  const io::Configuration c = configuration_of(options.finder);
  settings.navigator = {c.finder,  c.heading,  c.column_range, c.range_memory,
                        c.tracker, c.steering, c.frame_watch,  c.lens_watch};
  settings.node.speed_m_s = options.speed_m_s;
  settings.node.is_steered = !options.is_recorded;
  if (!parse(options.pilot, settings.node.pilot))
    throw io::ConfigError("--pilot " + options.pilot + ": not known; give by_method, published or navigator");
  return settings;
}

node::ControlConfig control_of(const Options& options) {
  node::ControlConfig config;
  config.speed_max_m_s = options.speed_m_s;
  config.turn_without_opening = true;  // the navigator's turns at dead ends: it is a simulation
  return config;
}

/// Perception and control between the topics. The transport's threads and the ticks take turns.
class Pilot {
 public:
  explicit Pilot(const Options& options)
      : options_(options), perception_(settings_of(options)), control_(control_of(options)) {
    if (const auto camera = camera_of(options.finder)) {
      has_own_camera_ = true;
      take_own_camera(camera->model());
    }
    if (!options.csv.empty()) {
      table_.emplace(options.csv);
      table_->write(io::csv_header(false));
    }
  }

  void fly() {
    GzLink link(
        options_.topics, [this](const node::ImageMessage& m) { take(m); },
        [this](const node::CameraInfoMessage& m) { take(m); });
    {
      const std::lock_guard lock(mutex_);
      link_ = &link;
    }
    auto report_at = Steady::now() + kReport;
    while (!is_interrupted() && !is_done()) {
      std::this_thread::sleep_for(kTick);
      tick(link);
      if (options_.quiet || Steady::now() < report_at) continue;
      report_at += kReport;
      report();
    }
    const std::lock_guard lock(mutex_);
    link.send(0.0, 0.0);
    link_ = nullptr;
    if (table_) table_->commit();
  }

  [[nodiscard]] std::int64_t frames() const noexcept { return frames_; }

 private:
  void take_own_camera(const CameraModel& model) {
    node::CameraInfoMessage m;
    m.width = static_cast<std::uint32_t>(model.width);
    m.height = static_cast<std::uint32_t>(model.height);
    m.distortion_model = to_string(model.distortion_model);
    m.distortion.assign(model.distortion.begin(), model.distortion.begin() + coefficient_count(model.distortion_model));
    m.matrix = {model.focal_length_x_px,
                0,
                model.principal_point_x_px,
                0,
                model.focal_length_y_px,
                model.principal_point_y_px,
                0,
                0,
                1};
    perception_.take(m);
  }

  void take(const node::CameraInfoMessage& m) {
    const std::lock_guard lock(mutex_);
    if (!has_own_camera_) perception_.take(m);
  }

  void take(const node::ImageMessage& m) {
    const std::lock_guard lock(mutex_);
    if (link_ == nullptr || (options_.limit > 0 && frames_ >= options_.limit)) return;
    // Gazebo's clock, carried on by ours between frames: a watchdog must not wait for a clock that may stop.
    arrival_ = Steady::now();
    now_ns_ = std::max(m.stamp_ns, node::Time_ns{1});
    const node::ImageAnswer answer = perception_.take(m, now_ns_);
    fault_ = answer.fault;
    if (!answer.sighting) return;
    const node::Sighting& s = *answer.sighting;
    control_.take(node::OpenSpaceNews{s.stamp_ns, s.open_space.status, s.manoeuvre == Manoeuvre::kTurn}, now_ns_);
    const auto command = control_.take(node::HeadingNews{s.stamp_ns, s.forward_m_s, s.heading.yaw_rate_rad_s}, now_ns_);
    if (command) link_->send(command->forward_m_s, command->yaw_rate_rad_s);
    if (!first_ns_) first_ns_ = s.stamp_ns;
    if (table_)
      table_->write(io::csv_line({options_.topics.image, frames_, node::seconds_of(s.stamp_ns - *first_ns_),
                                  s.open_space, s.heading, answer.fault},
                                 false));
    ++frames_;
  }

  void tick(GzLink& link) {
    const std::lock_guard lock(mutex_);
    link.enable();
    if (!arrival_) return;
    const auto waited = std::chrono::duration_cast<std::chrono::nanoseconds>(Steady::now() - *arrival_);
    const auto command = control_.tick(now_ns_ + waited.count());
    if (command) link.send(command->forward_m_s, command->yaw_rate_rad_s);
  }

  bool is_done() {
    const std::lock_guard lock(mutex_);
    return options_.limit > 0 && frames_ >= options_.limit;
  }

  void report() {
    const std::lock_guard lock(mutex_);
    if (!arrival_) {
      print_line("adit: no image on " + options_.topics.image + " yet; does the world run, and is the topic right?");
      return;
    }
    const auto waited = std::chrono::duration_cast<std::chrono::nanoseconds>(Steady::now() - *arrival_);
    print_line("adit: " + std::to_string(frames_) + " frames; " + control_.alarm_text(now_ns_ + waited.count()) +
               (fault_.empty() ? "" : "; " + fault_));
  }

  const Options& options_;
  std::mutex mutex_;
  node::Perception perception_;
  node::Control control_;
  std::optional<io::OutputFile> table_;
  GzLink* link_ = nullptr;
  bool has_own_camera_ = false;
  std::optional<Steady::time_point> arrival_;
  node::Time_ns now_ns_ = 0;
  std::optional<node::Time_ns> first_ns_;
  std::int64_t frames_ = 0;
  std::string fault_;
};

ExitCode run(const Options& options) {
  FileUses uses;
  uses.reads(options.finder);
  uses.writes("--csv", options.csv);
  watch_signals();
  Pilot pilot(options);
  pilot.fly();
  if (!options.quiet) print_line("adit: " + std::to_string(pilot.frames()) + " frames");
  return is_interrupted() ? kInterrupted : kSuccess;
}

}  // namespace

void add_gz(CLI::App& app, ExitCode& exit_code) {
  CLI::App* gz = app.add_subcommand("gz", "Fly a vehicle in Gazebo on what its camera shows");
  auto options = std::make_shared<Options>();
  gz->add_option("--image", options->topics.image, "Images (/camera)")->type_name("TOPIC");
  gz->add_option("--camera-info", options->topics.camera_info, "Calibration (camera_info beside the images)")
      ->type_name("TOPIC");
  gz->add_option("--cmd", options->topics.command, "Velocity command, a Twist (/cmd_vel)")->type_name("TOPIC");
  gz->add_option("--enable", options->topics.enable, "Boolean that starts the vehicle's controller")
      ->type_name("TOPIC");
  gz->add_option("--speed", options->speed_m_s, "Forward speed (0.2)")->type_name("M/S")->check(NumberIn(0.0, 10.0));
  gz->add_option("--pilot", options->pilot, "by_method, published or navigator (by_method)")->type_name("NAME");
  gz->add_flag("--recorded", options->is_recorded,
               "The camera does not follow the commands: what is played is a recording");
  add_finder_options(*gz, options->finder);
  gz->add_option("--csv", options->csv, "Table of the answers, as adit run makes it")->type_name("FILE");
  gz->add_option("--limit", options->limit, "End after so many frames")
      ->type_name("N")
      ->check(NumberIn(std::int64_t{1}, std::int64_t{1} << 40));
  gz->add_flag("--quiet", options->quiet, "No reports");
  gz->footer("Example: adit gz --image /camera --cmd /adit_quadrotor/cmd_vel --speed 0.5");
  gz->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
