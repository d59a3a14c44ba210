#include "bench_targets.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "adit/cpu_target.hpp"
#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

std::string refusal(const std::string& where, const std::string& name) {
  return fmt::format("{}: '{}' is not a CPU target of this machine; there are: {}", where, name,
                     fmt::join(supported_cpu_targets(), ", "));
}

}  // namespace

std::vector<std::string> supported_target_names() {
  const auto names = supported_cpu_targets();
  return {names.begin(), names.end()};
}

std::string target_in_use() {
  const char* wanted = std::getenv("ADIT_TARGET");  // NOLINT(concurrency-mt-unsafe): nobody writes the environment
  if (wanted != nullptr && cpu_target_request_refused()) throw io::ConfigError(refusal("ADIT_TARGET", wanted));
  return std::string(cpu_target());
}

void force_target(const std::string& name) {
  if (!use_cpu_target(name)) throw io::ConfigError(refusal("--target", name));
}

}  // namespace adit::tools
