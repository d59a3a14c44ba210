#include "shard.hpp"

#include <cstdio>

namespace adit::tools {
namespace {

std::string taken(const std::string& text, Shard& shard) {
  int index = 0, count = 0, read = 0;
  if (std::sscanf(text.c_str(), "%d/%d%n", &index, &count, &read) != 2 ||
      static_cast<std::size_t>(read) != text.size() || count < 1 || count > kShardsMax || index < 1 || index > count)
    return "'" + text + "' is not I/N with I from 1 to N, N up to " + std::to_string(kShardsMax);
  shard = {index, count};
  return "";
}

}  // namespace

void add_shard_option(CLI::App& subcommand, Shard& shard, bool hidden) {
  CLI::Option* option = subcommand
                            .add_option_function<std::string>(
                                "--shard",
                                [&shard](const std::string& text) {
                                  if (const std::string why = taken(text, shard); !why.empty())
                                    throw CLI::ValidationError("--shard", why);
                                },
                                "Only the I-th of N pieces; 'adit merge' joins them")
                            ->type_name("I/N");
  if (hidden) option->group("");
}

void Fingerprint::add_bytes(const void* bytes, std::size_t size) noexcept {
  const auto* at = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ at[i]) * 1099511628211u;
}

void Fingerprint::add(std::string_view text) noexcept {
  add_bytes(text.data(), text.size());
  add_bytes("\n", 1);
}

std::string Fingerprint::text() const {
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
  return digits;
}

}  // namespace adit::tools
