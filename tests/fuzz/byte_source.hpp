// Turns a fuzzer's bytes into numbers, and stops the program where a promise is broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace adit::fuzz {

/// Hands out the input from its start; zeros when it is used up.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), left_(size) {}

  template <class Number>
  Number take() {
    Number number{};
    const std::size_t count = left_ < sizeof(Number) ? left_ : sizeof(Number);
    if (count > 0) std::memcpy(&number, bytes_, count);
    bytes_ += count;
    left_ -= count;
    return number;
  }

  /// What has not been taken yet.
  [[nodiscard]] const std::uint8_t* rest() const { return bytes_; }
  [[nodiscard]] std::size_t rest_size() const { return left_; }

 private:
  const std::uint8_t* bytes_;
  std::size_t left_;
};

inline void require(bool promise, const char* words) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", words);
  std::abort();
}

/// A message for a person: one line, that begins with the place of the fault, and is no copy of the input.
inline void require_message(std::string_view message, std::string_view start) {
  if (message.starts_with(start) && message.find_first_of("\n\r") == std::string_view::npos && message.size() < 1000) {
    return;
  }
  std::fprintf(stderr, "broken promise: one short line that begins with %.*s, not:\n[%.*s]\n",
               static_cast<int>(start.size()), start.data(), static_cast<int>(message.size()), message.data());
  std::abort();
}

}  // namespace adit::fuzz
