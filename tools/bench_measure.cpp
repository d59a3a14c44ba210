#include "bench_measure.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "adit/io/image_file.hpp"
#include "bench_targets.hpp"
#include "interrupt.hpp"
#include "opencv_chains.hpp"

namespace adit::tools {
namespace {

// One turn of each contender. Long turns of the fast ones, so that each runs as it would on its own; a few untimed
// calls first, because the one before has filled the caches with its own things.
constexpr int kFramesPerTurn = 100;
constexpr int kStrongPerTurn = 10;
constexpr int kAditPerTurn = 20;
constexpr int kUntimed = 5;

constexpr int k4kWidth_px = 3840;
constexpr int k4kHeight_px = 2160;
constexpr int k4kSize_px = 101;

/// Makes the compiler believe that somebody reads what is behind the pointer.
void look_at(const void* memory) { asm volatile("" : : "r"(memory) : "memory"); }

template <class Call>
double time_of(TimeKind kind, Call&& call) {
  const double begin_ms = now_ms(kind);
  call();
  return now_ms(kind) - begin_ms;
}

template <class Call>
void time_turn(TimeKind kind, Samples& samples, int untimed, int timed, Call&& call) {
  for (int i = 0; i < untimed; ++i) call();
  for (int i = 0; i < timed; ++i) samples.add(time_of(kind, call));
}

cv::Mat noise_like(const cv::Mat& frame) {
  cv::Mat noise(frame.size(), CV_8UC3);
  cv::RNG chance(1);
  chance.fill(noise, cv::RNG::UNIFORM, 0, 256);
  return noise;
}

FinderConfig paper_preset_4k() {
  FinderConfig config = paper_preset();
  config.patch_size_px = k4kSize_px;
  config.structuring_element_size_px = k4kSize_px;
  return config;
}

/// The other frames of ours that a ratio or a limit is asked of. They take turns with all else: a processor's clock
/// goes up and down by half within a run, and what is timed at its end would be compared with another machine.
class OtherFrames {
 public:
  explicit OtherFrames(const cv::Mat& bgr) : bgr_(bgr), adit_(FinderConfig{}), large_(paper_preset_4k()) {
    cv::resize(bgr, large_bgr_, {k4kWidth_px, k4kHeight_px}, 0, 0, cv::INTER_LINEAR);
    (void)large_.find(io::view_of(large_bgr_));
  }
  void turn(TimeKind kind, BenchFigures& figures) {
    time_turn(kind, figures.adit_frame, kUntimed, kAditPerTurn, [&] { (void)adit_.find(io::view_of(bgr_)); });
    time_turn(kind, figures.frame_4k, 0, 1, [&] { (void)large_.find(io::view_of(large_bgr_)); });
  }

 private:
  cv::Mat bgr_, large_bgr_;
  OpenSpaceFinder adit_, large_;
};

/// Frames by ours, their copy and the chains of OpenCV, in turns.
void time_rivals(const BenchSubject& subject, double seconds, BenchFigures& figures) {
  const TimeKind kind = subject.time_kind;
  OpenSpaceFinder finder(paper_preset());
  const ImageView view = io::view_of(subject.bgr);
  const std::size_t bytes = subject.bgr.total() * subject.bgr.elemSize();
  std::vector<std::uint8_t> copy(bytes, 1);
  StrongOpenCvChain strong(finder.config(), subject.bgr.size());
  OpenCvChain opencv(finder.config(), subject.bgr.size());
  OtherFrames others(subject.bgr);
  for (int i = 0; i < 2 * kFramesPerTurn; ++i) (void)finder.find(view);
  const double begin_ms = now_ms();
  const auto is_enough = [&] {
    const double spent = (now_ms() - begin_ms) / 1000.0;
    return is_interrupted() || spent >= 4.0 * seconds || (spent >= seconds && figures.frame.count() >= kFramesMin);
  };
  do {
    const std::int64_t before = interruptions();
    for (int i = 0; i < kUntimed; ++i) (void)finder.find(view);
    for (int i = 0; i < kFramesPerTurn; ++i) {
      OpenSpace seen;
      figures.frame.add(time_of(kind, [&] { seen = finder.find(view); }));
      for (std::size_t s = 0; s < figures.stages.size(); ++s) {
        figures.stages[s].add(static_cast<double>(seen.stage_ns[s]) * 1e-6);
      }
    }
    figures.interruptions += interruptions() - before;
    time_turn(kind, figures.copy, kUntimed, kFramesPerTurn, [&] {
      std::memcpy(copy.data(), subject.bgr.data, bytes);
      look_at(copy.data());
    });
    time_turn(kind, figures.strong, 1, kStrongPerTurn, [&] { (void)strong.find(subject.bgr); });
    time_turn(kind, figures.opencv, 0, 1, [&] { (void)opencv.find(subject.bgr); });
    others.turn(kind, figures);
  } while (!is_enough());
}

/// find() on one picture for a share of the time, at least `least` times unless that takes four times as long.
void time_picture(TimeKind kind, const cv::Mat& bgr, const FinderConfig& config, double seconds, std::size_t least,
                  Samples& samples) {
  OpenSpaceFinder finder(config);
  const ImageView view = io::view_of(bgr);
  (void)finder.find(view);
  const double begin_ms = now_ms();
  double spent = 0.0;
  do {
    samples.add(time_of(kind, [&] { (void)finder.find(view); }));
    spent = (now_ms() - begin_ms) / 1000.0;
  } while (!is_interrupted() && (spent < seconds || (samples.count() < least && spent < 4.0 * seconds)));
}

void time_targets(const BenchSubject& subject, double seconds, BenchFigures& figures) {
  const std::vector<std::string> names = supported_target_names();
  for (const std::string& name : names) {
    if (is_interrupted()) break;
    force_target(name);
    figures.targets.emplace_back(name, Samples());
    time_picture(subject.time_kind, subject.bgr, paper_preset(), seconds / static_cast<double>(names.size()), 20,
                 figures.targets.back().second);
  }
  force_target(figures.target);
}

}  // namespace

BenchFigures measure(const BenchSubject& subject) {
  cv::setNumThreads(1);
  BenchFigures figures;
  figures.time_kind = subject.time_kind;
  figures.frame_name = subject.name;
  figures.size = subject.bgr.size();
  const FinderConfig defaults = paper_preset();
  figures.patch_size_px = scaled_size_px(defaults.patch_size_vga_px, figures.size.width);
  figures.structuring_element_size_px = scaled_size_px(defaults.structuring_element_size_vga_px, figures.size.width);
  figures.target = target_in_use();
  figures.core = pin_to_core();
  time_rivals(subject, 0.85 * subject.seconds, figures);
  time_picture(subject.time_kind, noise_like(subject.bgr), paper_preset(), 0.05 * subject.seconds, 20, figures.noise);
  time_targets(subject, 0.1 * subject.seconds, figures);
  return figures;
}

}  // namespace adit::tools
