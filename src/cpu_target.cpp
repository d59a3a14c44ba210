#include "adit/cpu_target.hpp"

#include <array>
#include <atomic>
#include <cstdlib>

#include "kernels/pixel_loops.hpp"

namespace adit {
namespace {

struct Target {
  std::string_view name;
  const kernels::PixelLoops* loops;
};

/// What this machine can run, the fastest first.
class Targets {
 public:
  Targets() {
#if defined(ADIT_TARGETS_X86)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq")) {
      add("avx512", kernels::kAvx512Loops);
    }
    if (__builtin_cpu_supports("avx2")) add("avx2", kernels::kAvx2Loops);
    if (__builtin_cpu_supports("sse4.1")) add("sse41", kernels::kSse41Loops);
#elif defined(ADIT_TARGETS_NEON)
    add("neon", kernels::kNeonLoops);
#elif defined(ADIT_TARGETS_WASM)
    add("wasm", kernels::kWasmLoops);
#endif
    add("plain", kernels::kPlainLoops);
    const char* wanted = std::getenv("ADIT_TARGET");  // NOLINT(concurrency-mt-unsafe): once, under the static's guard
    in_use_.store(&targets_[0]);
    refused_ = wanted != nullptr && *wanted != '\0' && !use(wanted);
  }

  bool use(std::string_view name) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (targets_[i].name != name) continue;
      in_use_.store(&targets_[i], std::memory_order_release);
      return true;
    }
    return false;
  }

  [[nodiscard]] const Target& in_use() const noexcept { return *in_use_.load(std::memory_order_acquire); }
  [[nodiscard]] std::span<const std::string_view> names() const noexcept { return {names_.data(), count_}; }
  [[nodiscard]] bool refused() const noexcept { return refused_; }

 private:
  void add(std::string_view name, const kernels::PixelLoops& loops) noexcept {
    targets_[count_] = {name, &loops};
    names_[count_] = name;
    ++count_;
  }

  std::array<Target, 4> targets_{};
  std::array<std::string_view, 4> names_{};
  std::size_t count_ = 0;
  std::atomic<const Target*> in_use_{nullptr};
  bool refused_ = false;
};

Targets& targets() noexcept {
  static Targets all;
  return all;
}

}  // namespace

std::span<const std::string_view> supported_cpu_targets() noexcept { return targets().names(); }
std::string_view cpu_target() noexcept { return targets().in_use().name; }
bool cpu_target_request_refused() noexcept { return targets().refused(); }
bool use_cpu_target(std::string_view name) noexcept { return targets().use(name); }

const kernels::PixelLoops& kernels::pixel_loops() noexcept { return *targets().in_use().loops; }

}  // namespace adit
