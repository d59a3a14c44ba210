#include "steady_command.hpp"

namespace adit::tools {

std::optional<HeadingCommand> steady_command(HeadingConfig config, const OpenSpace& open_space) {
  if (!open_space.found()) return std::nullopt;
  // With these, any rate is reached within one step that is shorter than the hold.
  config.yaw_acceleration_max_rad_s2 = 1000.0;
  config.hold_after_s = 1.0;
  HeadingController controller(config);
  controller.update(open_space, 0.0);
  return controller.update(open_space, 0.5);
}

}  // namespace adit::tools
