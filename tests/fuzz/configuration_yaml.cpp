// Configuration files and `--set` assignments of any bytes: refused in one line, or a configuration that is good.
#include <string_view>

#include "adit/io/configuration.hpp"
#include "adit/io/errors.hpp"
#include "byte_source.hpp"

using adit::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  adit::io::Configuration configuration;
  try {
    adit::io::read_yaml(text, "NAME", configuration);
    require(!fault_of(configuration.finder), "an accepted finder section is good");
    require(!fault_of(configuration.heading), "an accepted heading section is good");
    const std::string written = to_yaml(configuration);
    adit::io::Configuration again;
    adit::io::read_yaml(written, "NAME", again);
    require(to_yaml(again) == written, "what to_yaml writes reads back the same");
  } catch (const adit::io::ConfigError& error) {
    adit::fuzz::require_message(error.what(), "NAME");
  }
  try {
    adit::io::Configuration assigned;
    adit::io::set_field(text, assigned);
    require(!fault_of(assigned.finder) && !fault_of(assigned.heading), "an accepted assignment is good");
  } catch (const adit::io::ConfigError& error) {
    adit::fuzz::require_message(error.what(), "--set");
  }
  return 0;
}
