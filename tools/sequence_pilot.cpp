#include "sequence_pilot.hpp"

namespace adit::tools {

SequencePilot::SequencePilot(const io::Configuration& configuration, const std::optional<Camera>& camera) {
  if (configuration.finder.method == Method::kPaper) {
    controller_.emplace(configuration.heading);
    return;
  }
  const NavigatorConfig config = io::navigator_config_of(configuration);
  camera ? navigator_.emplace(config, *camera) : navigator_.emplace(config);
}

Followed SequencePilot::steer(const Sight& sight, double stamp_s) {
  const NavigatorCommand command = navigator_->steer(sight, stamp_s, {.yaw_rate_rad_s = 0.0, .speed_m_s = 0.0});
  const Track* track = navigator_->tracker().chosen();
  return {sight.open_space, command.heading, command.speed_scale, track ? std::optional(*track) : std::nullopt};
}

Followed SequencePilot::see(const ImageView& frame, double stamp_s, StageImages* images) {
  return steer(images ? navigator_->look(frame, *images) : navigator_->look(frame), stamp_s);
}

Followed SequencePilot::see_flash(const ImageView& frame, const ImageView& before, double stamp_s) {
  return steer(navigator_->look_flash(frame, before), stamp_s);
}

Followed SequencePilot::follow(const OpenSpace& seen, double stamp_s) {
  return {seen, controller_->update(seen, stamp_s), std::nullopt, std::nullopt};
}

HeadingCommand SequencePilot::miss(double stamp_s) {
  return navigator_ ? navigator_->tick(stamp_s).heading : controller_->tick(stamp_s);
}

void SequencePilot::use_lamp(const LampPattern& known, bool learn) {
  if (navigator_) navigator_->use_lamp(known, learn);
}

std::optional<LampPattern> SequencePilot::lamp() const {
  return navigator_ ? std::optional(navigator_->lamp()) : std::nullopt;
}

}  // namespace adit::tools
