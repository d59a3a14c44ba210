// The simulator's own generator: the same numbers on every machine, library and number of threads.
#pragma once

#include <cstdint>

namespace adit::sim {

/// PCG32 (O'Neill, 2014, XSH RR 64/32). Streams of one seed are independent of each other, so that a new user of
/// randomness does not shift the numbers of the others.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) noexcept;

  [[nodiscard]] std::uint32_t bits() noexcept;
  /// [0, 1), with 32 bits.
  [[nodiscard]] double uniform() noexcept;
  /// Standard normal: Marsaglia's polar method, whose only library calls are log and sqrt.
  [[nodiscard]] double normal() noexcept;

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace adit::sim
