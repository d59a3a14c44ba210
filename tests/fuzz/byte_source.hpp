// Turns a fuzzer's bytes into numbers, and stops the program where a promise is broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

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

}  // namespace adit::fuzz
