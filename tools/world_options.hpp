// The options that say where one is, alike for `adit fly` and `adit render`.
#pragma once

#include <CLI/App.hpp>

#include "file_uses.hpp"
#include "fly_setup.hpp"

namespace adit::tools {

/// COURSE, --world, --start, --models, --mesh-scale, --mesh-up, --world-lights, --door.
void add_world_options(CLI::App& command, FlyOptions& options);

/// The files that these options and --config name, as read. @throws io::InputError for a course that is not there
void add_reads(const FlyOptions& options, FileUses& uses);

}  // namespace adit::tools
