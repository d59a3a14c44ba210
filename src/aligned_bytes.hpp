// Memory for planes and rows of pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>

namespace adit {

/// Bytes on a cache line's boundary, 0 at first; only grows. A vector that lies across two lines costs twice.
class AlignedBytes {
 public:
  void reserve(std::size_t size) {
    if (size <= size_) return;
    bytes_.reset(static_cast<std::uint8_t*>(::operator new (size, std::align_val_t{kAlignment})));
    std::memset(bytes_.get(), 0, size);
    size_ = size;
  }
  [[nodiscard]] std::uint8_t* get() const noexcept { return bytes_.get(); }

  static constexpr std::size_t kAlignment = 64;
  [[nodiscard]] static constexpr std::size_t rounded_up(std::size_t size) noexcept {
    return (size + kAlignment - 1) / kAlignment * kAlignment;
  }

 private:
  struct Free {
    void operator()(std::uint8_t* bytes) const noexcept { ::operator delete (bytes, std::align_val_t{kAlignment}); }
  };
  std::unique_ptr<std::uint8_t, Free> bytes_;
  std::size_t size_ = 0;
};

}  // namespace adit
