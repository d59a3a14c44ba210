// The options that say where one is, alike for `adit fly` and `adit render`.
#pragma once

#include <CLI/App.hpp>

#include "fly_setup.hpp"

namespace adit::tools {

/// COURSE, --world, --start, --models, --mesh-scale, --mesh-up, --world-lights.
void add_world_options(CLI::App& command, FlyOptions& options);

}  // namespace adit::tools
