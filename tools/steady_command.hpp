// What the controller makes of a picture that has no neighbours in time.
#pragma once

#include <optional>

#include "adit/finder.hpp"
#include "adit/heading.hpp"

namespace adit::tools {

/// The command that a HeadingController of this configuration settles at when the same answer keeps coming: gain, dead
/// band and limit of the rate count, the limit of its change does not. Nothing when no opening was found: a single
/// picture then commands nothing.
[[nodiscard]] std::optional<HeadingCommand> steady_command(HeadingConfig config, const OpenSpace& open_space);

}  // namespace adit::tools
