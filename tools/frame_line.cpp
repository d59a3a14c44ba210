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
  while (!judging_.empty()) pop_judged();  // the pilot belongs to the frames that went in under it
  if (settings_.learn_lamp && is_pilots()) settings_.lamp = pilot_->lamp();
  pilot_.reset();
  last_pixels_.release();
  if (!is_sequence) return;
  pilot_ = std::make_unique<SequencePilot>(settings_.configuration, settings_.camera);
  if (settings_.lamp || settings_.learn_lamp)
    pilot_->use_lamp(settings_.lamp.value_or(LampPattern{}), settings_.learn_lamp);
}

LampPattern FrameLine::lamp() const noexcept {
  return is_pilots() ? *pilot_->lamp() : settings_.lamp.value_or(LampPattern{});
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
  // Pairs have no pictures of stages of their own: those of the later frame are shown.
  if (wants_stages(work) && (settings_.flash || !is_pilots())) {
    work.open_space = finder.explain(view, work.stages);
  } else if (!is_pilots() && !settings_.flash) {
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
  if (is_pilots()) {
    StageImages* images = wants_stages(work) && !settings_.flash ? &work.stages : nullptr;
    const Followed followed = is_pair ? pilot_->see_flash(view, io::view_of(before), work.frame.stamp_s)
                                      : pilot_->see(view, work.frame.stamp_s, images);
    work.open_space = followed.open_space;
    work.command = followed.command;
    work.track = followed.track;
  } else if (settings_.flash) {
    work.open_space = is_pair ? finders_.front().find_flash(view, io::view_of(before)) : finders_.front().find(view);
  }
  work.why = why_not_judged(work, settings_.camera);
}

void FrameLine::steer(FrameWork& work) {
  if (pilot_ && !work.open_space) {
    work.command = pilot_->miss(work.frame.stamp_s);
  } else if (pilot_ && !pilot_->judges()) {
    work.command = pilot_->follow(*work.open_space, work.frame.stamp_s).command;
  } else if (!pilot_ && work.open_space) {
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
