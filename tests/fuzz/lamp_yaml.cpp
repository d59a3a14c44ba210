// Files of lamp patterns of any bytes: refused in one line, or a pattern that is written and read again as it was.
#include <string_view>

#include "adit/io/lamp_file.hpp"
#include "byte_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    const adit::LampPattern pattern = adit::io::lamp_of_yaml(text, "NAME");
    adit::fuzz::require(*fault_of(pattern) == '\0', "an accepted pattern is a pattern");
    const std::string written = adit::io::to_yaml(pattern);
    adit::fuzz::require(adit::io::to_yaml(adit::io::lamp_of_yaml(written, "WRITTEN")) == written,
                        "what was written is read as it was");
  } catch (const adit::io::ConfigError& error) {
    adit::fuzz::require_message(error.what(), "NAME");
  }
  return 0;
}
