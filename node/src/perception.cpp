#include "adit/node/perception.hpp"

#include <cmath>
#include <stdexcept>

#include "adit/node/settings.hpp"

namespace adit::node {
namespace {

// A gyroscope runs at 100 Hz and more: an older sample is of another motion.
constexpr double kYawRateFresh_s = 0.1;

bool is_published(const PerceptionSettings& s) noexcept {
  if (s.node.pilot != Pilot::kByMethod) return s.node.pilot == Pilot::kPublished;
  return s.navigator.finder.method == Method::kPaper;
}

bool is_same(const CameraModel& a, const CameraModel& b) noexcept {
  return a.width == b.width && a.height == b.height && a.focal_length_x_px == b.focal_length_x_px &&
         a.focal_length_y_px == b.focal_length_y_px && a.principal_point_x_px == b.principal_point_x_px &&
         a.principal_point_y_px == b.principal_point_y_px && a.distortion_model == b.distortion_model &&
         a.distortion == b.distortion;
}

OpenSpaceFinder finder_of(const FinderConfig& config, const std::optional<CameraModel>& camera) {
  return camera ? OpenSpaceFinder(config, Camera(*camera)) : OpenSpaceFinder(config);
}

}  // namespace

struct Perception::Chain {
  Chain(const PerceptionSettings& s, const std::optional<CameraModel>& camera) : speed_m_s(s.node.speed_m_s) {
    const NavigatorConfig& n = s.navigator;
    if (!is_published(s)) {
      if (camera)
        navigator.emplace(n, Camera(*camera));
      else
        navigator.emplace(n);
      return;
    }
    finder.emplace(finder_of(n.finder, camera));
    watch.emplace(n.frame_watch);
    controller.emplace(n.heading);
  }

  void reset() noexcept {
    if (navigator) navigator->reset();
    if (controller) controller->reset();
    if (watch) watch->reset();
  }

  void see(const ImageView& view, double stamp_s, const Motion& motion, Sighting& sighting) noexcept {
    double scale = 1.0;
    if (navigator) {
      const Sight sight = navigator->look(view);
      const NavigatorCommand command = navigator->steer(sight, stamp_s, motion);
      sighting.open_space = sight.open_space;
      sighting.heading = command.heading;
      sighting.manoeuvre = command.manoeuvre;
      scale = command.speed_scale;
    } else {
      sighting.open_space = finder->find(view);
      const Status stream = watch->judge(view);
      // As in Navigator::look: what the frame alone shows to be wrong is the better name for it.
      if (stream != Status::kFound && sighting.open_space.found()) sighting.open_space.status = stream;
      sighting.heading = controller->update(sighting.open_space, stamp_s);
      sighting.manoeuvre = sighting.open_space.found() ? Manoeuvre::kFollow : Manoeuvre::kWait;
    }
    sighting.forward_m_s = sighting.heading.state == HeadingState::kHold ? 0.0 : scale * speed_m_s;
  }

  double speed_m_s;
  std::optional<Navigator> navigator;
  std::optional<OpenSpaceFinder> finder;
  std::optional<FrameWatch> watch;
  std::optional<HeadingController> controller;
};

struct Perception::Parts {
  PerceptionSettings settings, wanted;
  std::unique_ptr<Chain> chain;
  std::unique_ptr<OpenSpaceFinder> explainer;
};

Perception::Perception() : Perception(PerceptionSettings{}) {}

Perception::Perception(const PerceptionSettings& settings) : parts_(std::make_unique<Parts>()) { configure(settings); }

Perception::~Perception() = default;

const PerceptionSettings& Perception::settings() const noexcept { return parts_->settings; }
const FinderConfig& Perception::finder_config() const noexcept { return parts_->settings.navigator.finder; }

void Perception::configure(const PerceptionSettings& settings) {
  if (const auto fault = fault_of(settings.node)) throw std::invalid_argument(*fault);
  // Checked by the constructors; what they refuse leaves all as it was.
  auto chain = std::make_unique<Chain>(settings, camera_);
  const bool is_first = !parts_->chain;
  if (is_first || settings.node.stamp_jump_s != parts_->settings.node.stamp_jump_s)
    stamps_ = StampCheck(settings.node.stamp_jump_s);
  parts_->settings = parts_->wanted = settings;
  parts_->chain = std::move(chain);
  parts_->explainer.reset();
}

std::vector<Parameter> Perception::parameters() const { return parameters_of(parts_->wanted); }

std::string Perception::set(const std::string& name, const ParameterValue& value) {
  return set_parameter(parts_->wanted, name, value);
}

void Perception::apply() { configure(PerceptionSettings(parts_->wanted)); }

void Perception::rebuild() {
  parts_->chain = std::make_unique<Chain>(parts_->settings, camera_);
  parts_->explainer.reset();
}

void Perception::take(const CameraInfoMessage& message) {
  ++camera_infos_;
  CameraReading reading = camera_of(message);
  camera_fault_ = std::move(reading.fault);
  broken_camera_infos_ += !camera_fault_.empty();
  // A calibration that is broken is no reason to forget the good one before it.
  if (!reading.model || (camera_ && is_same(*camera_, *reading.model))) return;
  camera_ = reading.model;
  rebuild();
}

void Perception::take_yaw_rate(double yaw_rate_rad_s, Time_ns stamp_ns) noexcept {
  if (!std::isfinite(yaw_rate_rad_s)) return;
  ++yaw_rates_;
  yaw_rate_rad_s_ = yaw_rate_rad_s;
  yaw_rate_ns_ = stamp_ns;
}

/// Seconds as doubles lose nothing when they are few.
double Perception::stamp_s(Time_ns stamp_ns) noexcept {
  if (!origin_ns_) origin_ns_ = stamp_ns;
  return seconds_of(stamp_ns - *origin_ns_);
}

void Perception::watch_size(const ImageView& view) noexcept {
  if (width_ != 0 && (view.width != width_ || view.height != height_)) {
    ++size_changes_;
    parts_->chain->reset();  // what was seen in pixels of another size is no guide
  }
  width_ = view.width;
  height_ = view.height;
}

void Perception::take_unreadable(std::string fault, Time_ns now_ns) {
  ++images_;
  ++unusable_images_;
  last_image_ns_ = now_ns;
  last_fault_ = std::move(fault);
}

ImageAnswer Perception::take(const ImageMessage& message, Time_ns now_ns) {
  ++images_;
  last_image_ns_ = now_ns;
  ImageReading reading = view_of(message);
  if (reading.view.data == nullptr) {
    ++unusable_images_;
    unknown_encodings_ += reading.is_unknown_encoding;
    last_fault_ = reading.fault;
    return {std::nullopt, std::move(reading.fault)};
  }
  const StampVerdict verdict = stamps_.judge(message.stamp_ns);
  if (!is_usable(verdict)) {
    last_fault_ = "stamp: " + std::string(to_string(verdict)) + ": the image is not used";
    return {std::nullopt, last_fault_};
  }
  if (verdict == StampVerdict::kRestarted) parts_->chain->reset();
  watch_size(reading.view);
  if (verdict != StampVerdict::kMissing) arrival_.add(now_ns - message.stamp_ns);
  Sighting sighting;
  sighting.stamp_ns = verdict == StampVerdict::kMissing ? now_ns : message.stamp_ns;
  Motion motion;
  motion.speed_m_s = parts_->settings.node.is_steered ? commanded_m_s_ : 0.0;
  if (!parts_->settings.node.is_steered) motion.yaw_rate_rad_s = 0.0;
  if (yaw_rate_rad_s_ && std::abs(seconds_of(sighting.stamp_ns - yaw_rate_ns_)) < kYawRateFresh_s) {
    motion.yaw_rate_rad_s = yaw_rate_rad_s_;
    ++images_with_yaw_rate_;
  }
  parts_->chain->see(reading.view, stamp_s(sighting.stamp_ns), motion, sighting);
  commanded_m_s_ = sighting.forward_m_s;
  last_status_ = sighting.open_space.status;
  last_flags_ = sighting.open_space.flags;
  last_fault_.clear();
  if (last_status_ == Status::kWrongSize && camera_) {
    ++wrong_sizes_;
    last_fault_ = "camera_info: it is of " + std::to_string(camera_->width) + " x " + std::to_string(camera_->height) +
                  " px, the image of " + std::to_string(width_) + " x " + std::to_string(height_) +
                  " px; calibrate at the size that is used";
  }
  return {sighting, last_fault_};
}

std::optional<StageImages> Perception::explain(const ImageMessage& message) {
  const ImageReading reading = view_of(message);
  if (reading.view.data == nullptr) return std::nullopt;
  if (!parts_->explainer) parts_->explainer = std::make_unique<OpenSpaceFinder>(finder_of(finder_config(), camera_));
  StageImages stages;
  const Status status = parts_->explainer->explain(reading.view, stages).status;
  if (status == Status::kBadFrame || status == Status::kWrongSize) return std::nullopt;
  return stages;
}

}  // namespace adit::node
