// `adit bench`: what a frame costs, beside a copy of it and beside OpenCV, in one run.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "adit/io/output_file.hpp"
#include "bench_report.hpp"
#include "bench_targets.hpp"
#include "drawn_frame.hpp"
#include "file_uses.hpp"
#include "interrupt.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

struct BenchOptions {
  double seconds = 10.0;
  std::string json_file;
  std::string input;
  std::string size;
  std::string target;
  bool is_cpu_time = false;
};

cv::Size size_of(const std::string& text) {
  cv::Size size;
  int read = 0;
  const int fields = std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &read);
  if (fields != 2 || text.size() != static_cast<std::size_t>(read) || std::min(size.width, size.height) < kSideMin_px ||
      std::max(size.width, size.height) > kSideMax_px) {
    throw CLI::ValidationError("--size", "'" + text + "' is not WIDTHxHEIGHT with sides of 16 to 8192 px");
  }
  return size;
}

BenchSubject subject_of(const BenchOptions& options) {
  BenchSubject subject;
  subject.seconds = options.seconds;
  subject.time_kind = options.is_cpu_time ? TimeKind::kUsed : TimeKind::kPassed;
  if (options.input.empty()) {
    subject.name = "a drawn tunnel";
    subject.bgr = cv::imdecode(std::vector<std::uint8_t>(drawn_frame().begin(), drawn_frame().end()), cv::IMREAD_COLOR);
  } else if (options.input == "noise") {
    subject.name = "noise";
    subject.bgr = cv::Mat(480, 640, CV_8UC3);
    cv::RNG(1).fill(subject.bgr, cv::RNG::UNIFORM, 0, 256);
  } else {
    subject.name = std::filesystem::path(options.input).filename().string();
    subject.bgr = io::bgr_of(io::read_image(options.input));
  }
  if (!options.size.empty()) cv::resize(subject.bgr, subject.bgr, size_of(options.size), 0, 0, cv::INTER_AREA);
  if (const auto fault = fault_of(io::view_of(subject.bgr)); !fault.empty()) {
    throw io::InputError(options.input + ": " + std::string(fault));
  }
  return subject;
}

ExitCode bench(const BenchOptions& options) {
  watch_signals();
  FileUses uses;
  if (options.input != "noise") uses.reads("--input", options.input);
  uses.writes("--json", options.json_file);
  if (!options.target.empty()) force_target(options.target);
  const BenchFigures figures = measure(subject_of(options));
  if (is_interrupted()) {
    print_line("adit: interrupted after " + std::to_string(figures.frame.count()) +
               " timed frames; figures of a part would mislead, so none are told");
    return kInterrupted;
  }
  if (!options.json_file.empty()) io::write_file(options.json_file, json_of(figures));
  if (options.json_file != "-") io::write_file("-", table_of(figures));
  return kSuccess;
}

}  // namespace

void add_bench(CLI::App& app, ExitCode& exit_code) {
  CLI::App* bench_app = app.add_subcommand("bench", "Time a frame and its stages, beside memcpy and OpenCV");
  auto options = std::make_shared<BenchOptions>();
  bench_app->add_option("--seconds", options->seconds, "About how long [10]")
      ->type_name("N")
      ->check(NumberIn(0.05, 3600.0));
  bench_app->add_option("--json", options->json_file, "All figures as JSON; - is stdout")->type_name("FILE");
  bench_app->add_option("--input", options->input, "The frame [a drawn tunnel]; noise: a frame of noise")
      ->type_name("IMAGE");
  bench_app->add_option("--size", options->size, "Resize the frame first")->type_name("WxH");
  bench_app->add_option("--target", options->target, "CPU target of the pixel loops [the best]")
      ->type_name("NAME")
      ->check(CLI::IsMember(supported_target_names()));
  bench_app->add_flag("--cpu-time", options->is_cpu_time,
                      "Count the time on the core, not the time that passed: for busy machines");
  bench_app->footer("Example: adit bench --seconds 10 --json bench.json");
  bench_app->callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace adit::tools
