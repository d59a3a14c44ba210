// `adit view`: what the robot sees and what adit answers, in a page, while it happens.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "adit/io/errors.hpp"
#include "adit/io/frame_source.hpp"
#include "adit/io/image_file.hpp"
#include "finder_options.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "sequence_pilot.hpp"
#include "subcommands.hpp"
#include "view_replay.hpp"
#include "view_server.hpp"

namespace adit::tools {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::string input;
  FinderOptions finder;
  ViewAddress address;
  io::SourceOptions source;
  bool loop = false;
};

/// Frames judged one by one, each when its time has come.
class Watch {
 public:
  Watch(const Options& options, LiveView& live, const io::Configuration& configuration)
      : options_(&options), live_(&live), camera_(camera_of(options.finder)) {
    use(configuration);
  }

  /// All frames of the source, or until a signal. Returns how many were judged.
  std::int64_t operator()() {
    do {
      std::int64_t before = judged_;
      for (const auto& source : io::open_sources({options_->input}, options_->source)) take(*source);
      if (judged_ == before && !is_interrupted())
        throw io::InputError(options_->input + ": no frame of it can be read");
    } while (options_->loop && !is_interrupted());
    return judged_;
  }

 private:
  void use(const io::Configuration& configuration) {
    configuration_ = configuration;
    finder_.emplace(make_finder(configuration.finder, camera_));
    pilot_.emplace(configuration, camera_);
  }

  void take(io::FrameSource& source) {
    const bool is_camera = options_->input.starts_with("/dev/");  // it keeps time itself
    pilot_.emplace(configuration_, camera_);
    const auto begin = Clock::now();
    while (!is_interrupted()) {
      auto frame = source.next();
      if (!frame) {
        if (!source.fault().empty()) print_line("adit: " + source.fault());
        return;
      }
      io::load_pixels(*frame);
      if (frame->pixels.empty()) {
        print_line("adit: " + frame->fault);
        continue;
      }
      if (!is_camera)
        wait_until(begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(frame->stamp_s)));
      if (const auto changed = live_->new_settings()) use(*changed);
      const ImageView view = io::view_of(frame->pixels);
      const Followed now =
          pilot_->judges() ? pilot_->see(view, frame->stamp_s) : pilot_->follow(finder_->find(view), frame->stamp_s);
      ++judged_;
      live_->show({std::move(frame->pixels), cv::Mat(), frame->stamp_s, now.open_space, now.command, std::nullopt,
                   now.speed_scale});
    }
  }

  static void wait_until(Clock::time_point time) {
    constexpr auto kLook = std::chrono::milliseconds(50);  // for a signal
    while (!is_interrupted() && Clock::now() < time)
      std::this_thread::sleep_until(std::min(time, Clock::now() + kLook));
  }

  const Options* options_;
  LiveView* live_;
  std::optional<Camera> camera_;
  io::Configuration configuration_;
  std::optional<OpenSpaceFinder> finder_;
  std::optional<SequencePilot> pilot_;
  std::int64_t judged_ = 0;
};

/// The page while `watch` works, and after that until a signal.
template <class Watching>
ExitCode show(const Options& options, LiveView& live, const Watching& watching) {
  std::int64_t shown = 0;
  {
    const ViewServer server(live, options.address);
    std::printf("%s\n", server.address().c_str());
    std::fflush(stdout);
    print_line("open the address in a browser, end with Ctrl-C");
    live.say("running");
    shown = watching();
    live.say("the source has ended");
    while (!is_interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  print_line("adit: " + std::to_string(shown) + " frames were shown");
  return kSuccess;
}

ExitCode run(const Options& options) {
  watch_signals();
  if (is_flight_folder(options.input)) {
    LiveView live("flight in " + options.input, {}, false, plan_of_folder(options.input));
    return show(options, live, [&] {
      std::int64_t shown = 0;
      do {
        shown += replay_flight(options.input, live);
      } while (options.loop && !is_interrupted());
      return shown;
    });
  }
  const io::Configuration configuration = configuration_of(options.finder);
  (void)io::open_sources({options.input}, options.source);  // before a page is promised
  LiveView live(options.input, configuration, true);
  Watch watch(options, live, configuration);
  return show(options, live, [&] { return watch(); });
}

}  // namespace

void add_view(CLI::App& app, ExitCode& exit_code) {
  CLI::App* view = app.add_subcommand("view", "Watch a camera or a recording live, in a page of this machine");
  auto options = std::make_shared<Options>();
  options->source.images_are_sequence = true;
  view->add_option("source", options->input, "Camera (/dev/videoN), video, images, or a folder of adit fly --out")
      ->required()
      ->type_name("SOURCE");
  add_finder_options(*view, options->finder);
  view->add_option("--fps", options->source.images_hz, "Frames a second of images (30)")
      ->type_name("HZ")
      ->check(NumberIn(0.001, 10000.0));
  view->add_flag("--loop", options->loop, "Begin again at the end");
  view->add_option("--listen", options->address.host, "Address to listen on (127.0.0.1); others get a token")
      ->type_name("ADDRESS");
  view->add_option("--port", options->address.port, "Of the page (any that is free)")
      ->type_name("N")
      ->check(NumberIn(1, 65535));
  view->footer("Example: adit view data/clip.avi --loop");
  view->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
