#include "adit/sim/random.hpp"

#include <bit>
#include <cmath>

namespace adit::sim {

Random::Random(std::uint64_t seed, std::uint64_t stream) noexcept : increment_((stream << 1u) | 1u) {
  static_cast<void>(bits());
  state_ += seed;
  static_cast<void>(bits());
}

std::uint32_t Random::bits() noexcept {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005ull + increment_;
  return std::rotr(static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u), static_cast<int>(old >> 59u));
}

double Random::uniform() noexcept { return bits() * 0x1p-32; }

double Random::normal() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u = 0.0, v = 0.0, s = 0.0;
  do {
    u = 2.0 * uniform() - 1.0;
    v = 2.0 * uniform() - 1.0;
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = v * scale;
  has_spare_ = true;
  return u * scale;
}

}  // namespace adit::sim
