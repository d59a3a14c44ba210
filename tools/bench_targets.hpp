// The CPU targets of the pixel loops, as `adit bench` sees them.
#pragma once

#include <string>
#include <vector>

namespace adit::tools {

/// Those that this CPU can run.
[[nodiscard]] std::vector<std::string> cpu_targets();
/// The one in use.
[[nodiscard]] std::string cpu_target();
/// Finders made from now on use this one. @throws io::ConfigError when it is unknown or this CPU cannot run it.
void force_cpu_target(const std::string& name);

}  // namespace adit::tools
