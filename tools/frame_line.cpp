#include "frame_line.hpp"

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>

#include "adit/io/draw.hpp"
#include "adit/io/image_file.hpp"
#include "finder_options.hpp"
#include "grey16_doubt.hpp"
#include "steady_command.hpp"

namespace adit::tools {
namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height) + " px"; }

/// Why the finder did not look at the picture; empty when it did.
std::string why_not_judged(const FrameWork& work, const std::optional<Camera>& camera) {
  const cv::Mat& pixels = work.frame.pixels;
  if (work.open_space->status == Status::kBadFrame) {
    return size_text(pixels.cols, pixels.rows) + ": " + std::string(fault_of(io::view_of(pixels)));
  }
  if (work.open_space->status == Status::kWrongSize && camera) {
    return size_text(pixels.cols, pixels.rows) + ", but the camera was calibrated at " +
           size_text(camera->model().width, camera->model().height);
  }
  return "";
}

}  // namespace

FrameLine::FrameLine(const LineSettings& settings, Receiver on_judged, Receiver on_drawn)
    : settings_(settings),
      on_judged_(std::move(on_judged)),
      on_drawn_(std::move(on_drawn)),
      room_(static_cast<std::size_t>(settings.jobs) * 2),
      pool_(settings.jobs) {
  for (int i = 0; i < settings.jobs; ++i) {
    finders_.push_back(make_finder(settings.configuration.finder, settings.camera));
    if (settings.lamp) finders_.back().set_lamp(*settings.lamp);
  }
}

void FrameLine::begin_source(bool is_sequence) {
  while (!judging_.empty()) pop_judged();  // the controller belongs to the frames that went in under it
  if (navigator_ && settings_.learn_lamp) settings_.lamp = navigator_->lamp();
  controller_.reset();
  navigator_.reset();
  last_pixels_.release();
  if (!is_sequence) return;
  if (settings_.configuration.finder.method == Method::kPaper) {
    controller_.emplace(settings_.configuration.heading);
    return;
  }
  const NavigatorConfig config = io::navigator_config_of(settings_.configuration);
  navigator_ =
      settings_.camera ? std::make_unique<Navigator>(config, *settings_.camera) : std::make_unique<Navigator>(config);
  if (settings_.lamp || settings_.learn_lamp) {
    navigator_->use_lamp(settings_.lamp.value_or(LampPattern{}), settings_.learn_lamp);
  }
}

LampPattern FrameLine::lamp() const noexcept {
  return navigator_ ? navigator_->lamp() : settings_.lamp.value_or(LampPattern{});
}

void FrameLine::push(io::Frame frame) {
  while (judging_.size() >= room_) pop_judged();
  auto work = std::make_shared<FrameWork>();
  work->frame = std::move(frame);
  work->number = pushed_++;
  work->wants_shot = settings_.wants_shot && settings_.wants_shot(work->number);
  // Not a share in the work: it keeps its task's outcome, and the two would keep each other for ever when a run ends
  // early.
  work->done = pool_.submit([this, at = work.get()](int worker) { judge(*at, worker); });
  judging_.push_back(std::move(work));
}

void FrameLine::finish() {
  while (!judging_.empty()) pop_judged();
  while (!drawing_.empty()) pop_drawn();
}

void FrameLine::judge(FrameWork& work, int worker) {
  io::load_pixels(work.frame);
  if (!work.frame.fault.empty()) {
    work.why = work.frame.fault;
    return;
  }
  const ImageView view = io::view_of(work.frame.pixels);
  OpenSpaceFinder& finder = finders_[static_cast<std::size_t>(worker)];
  if (settings_.wants_panel || work.wants_shot) {
    work.open_space = finder.explain(view, work.stages);
  } else if (!navigator_ && !settings_.flash) {
    work.open_space = finder.find(view);
  }
  work.doubt = grey16_doubt(work.frame.pixels, settings_.configuration.finder.grey16_depth_bits);
}

/// What needs the frames before: a pair of lamp on and off, and the navigator.
void FrameLine::judge_in_order(FrameWork& work) {
  if (!work.frame.fault.empty()) return;
  const cv::Mat before = std::exchange(last_pixels_, settings_.flash ? work.frame.pixels : cv::Mat());
  const ImageView view = io::view_of(work.frame.pixels);
  const bool is_pair = settings_.flash && !before.empty();
  if (navigator_) {
    const Sight sight = is_pair ? navigator_->look_flash(view, io::view_of(before)) : navigator_->look(view);
    work.open_space = sight.open_space;
    // A recording does not turn when it is told to: the camera is taken to stand, not to follow the commands.
    work.command = navigator_->steer(sight, work.frame.stamp_s, {.yaw_rate_rad_s = 0.0, .speed_m_s = 0.0}).heading;
  } else if (settings_.flash) {
    work.open_space = is_pair ? finders_.front().find_flash(view, io::view_of(before)) : finders_.front().find(view);
  }
  work.why = why_not_judged(work, settings_.camera);
}

void FrameLine::steer(FrameWork& work) {
  if (navigator_) {
    if (!work.open_space) work.command = navigator_->tick(work.frame.stamp_s).heading;
  } else if (controller_ && work.open_space) {
    work.command = controller_->update(*work.open_space, work.frame.stamp_s);
  } else if (controller_) {
    work.command = controller_->tick(work.frame.stamp_s);
  } else if (work.open_space) {
    work.command = steady_command(settings_.configuration.heading, *work.open_space);
  }
}

void FrameLine::pop_judged() {
  const Work work = std::move(judging_.front());
  judging_.pop_front();
  work->done.get();
  judge_in_order(*work);
  steer(*work);
  on_judged_(*work);
  if (!work->open_space || !(settings_.wants_panel || settings_.wants_png || work->wants_shot)) return;
  while (drawing_.size() >= room_) pop_drawn();
  work->done = pool_.submit([this, at = work.get()](int) { draw(*at); });
  drawing_.push_back(work);
}

void FrameLine::draw(FrameWork& work) const {
  const int depth_bits = settings_.configuration.finder.grey16_depth_bits;
  if (work.wants_shot)
    work.shot = shot_of(work.frame.pixels, *work.open_space, work.stages, settings_.configuration.finder);
  if (settings_.wants_panel) {
    const cv::Mat frame = io::bgr_of(work.frame.pixels, depth_bits);
    work.panel = io::side_by_side(frame, *work.open_space, work.stages, work.command);
    work.stages = {};
  }
  if (settings_.wants_png) {
    cv::Mat overlay = io::bgr_of(work.frame.pixels, depth_bits);
    io::draw_overlay(overlay, *work.open_space, work.command);
    cv::imencode(".png", overlay, work.png);
  }
}

void FrameLine::pop_drawn() {
  const Work work = std::move(drawing_.front());
  drawing_.pop_front();
  work->done.get();
  on_drawn_(*work);
}

}  // namespace adit::tools
