// The CPU targets of the pixel loops, as `adit bench` sees them.
#pragma once

#include <string>
#include <vector>

namespace adit::tools {

/// Those that this machine can run, the fastest first.
[[nodiscard]] std::vector<std::string> supported_target_names();

/// The one in use. @throws io::ConfigError when the environment variable ADIT_TARGET asks for one that is not there.
[[nodiscard]] std::string target_in_use();

/// From now on this one. @throws io::ConfigError when it is unknown or this machine cannot run it.
void force_target(const std::string& name);

}  // namespace adit::tools
