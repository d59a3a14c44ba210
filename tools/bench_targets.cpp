#include "bench_targets.hpp"

#include "adit/io/errors.hpp"

namespace adit::tools {

std::vector<std::string> cpu_targets() { return {"portable"}; }

std::string cpu_target() { return "portable"; }

void force_cpu_target(const std::string& name) {
  if (name != "portable") throw io::ConfigError("--target: '" + name + "' is not known; known are: portable");
}

}  // namespace adit::tools
