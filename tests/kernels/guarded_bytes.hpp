// Memory between two pages that must not be touched: one byte too far ends the test, under any compiler, and also for
// instructions that the address sanitizer does not watch.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace adit::judging {

/// Against which of the two pages the bytes lie.
enum class Against { kFirstPage, kLastPage };

class GuardedBytes {
 public:
  GuardedBytes(std::size_t size, Against against) : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    inner_ = (size + page_ - 1) / page_ * page_;
    void* all = mmap(nullptr, inner_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    all_ = static_cast<std::uint8_t*>(all);
    if (mprotect(all_ + page_, inner_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
    data_ = all_ + page_ + (against == Against::kLastPage ? inner_ - size : 0);
  }
  ~GuardedBytes() { munmap(all_, inner_ + 2 * page_); }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;

  [[nodiscard]] std::uint8_t* data() const { return data_; }
  /// From here on a write ends the test as well.
  void forbid_writing() const {
    if (mprotect(all_ + page_, inner_, PROT_READ) != 0) throw std::bad_alloc();
  }

 private:
  std::size_t page_;
  std::size_t inner_ = 0;
  std::uint8_t* all_ = nullptr;
  std::uint8_t* data_ = nullptr;
};

}  // namespace adit::judging
