// Work in pieces: --shard I/N does the I-th of N pieces, `adit merge` joins them (parts.hpp).
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <string_view>

namespace adit::tools {

/// One of `count` pieces of equal size, give or take one item: the items in a row, so that pieces join in their order.
struct Shard {
  int index = 0;  ///< 1 to count; 0: the whole
  int count = 0;

  [[nodiscard]] bool is_given() const noexcept { return count > 0; }
  [[nodiscard]] std::int64_t first(std::int64_t items) const noexcept { return items * (index - 1) / count; }
  /// One past its last.
  [[nodiscard]] std::int64_t end(std::int64_t items) const noexcept { return items * index / count; }
  /// All items are in the whole.
  [[nodiscard]] bool has(std::int64_t item, std::int64_t items) const noexcept {
    return !is_given() || (item >= first(items) && item < end(items));
  }
  /// "3/8"
  [[nodiscard]] std::string text() const { return std::to_string(index) + "/" + std::to_string(count); }
};

inline constexpr int kShardsMax = 1000000;

/// Adds --shard I/N, hidden from the page of --help that has to fit a screen when `hidden`.
void add_shard_option(CLI::App& subcommand, Shard& shard, bool hidden = false);

/// What the answer depends on, gathered into one number: pieces of different work never fit together.
class Fingerprint {
 public:
  void add(std::string_view text) noexcept;
  void add_bytes(const void* bytes, std::size_t size) noexcept;
  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t hash_ = 14695981039346656037u;  // FNV-1a, 64 bits
};

}  // namespace adit::tools
