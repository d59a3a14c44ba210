// Which build of the shading loops this CPU runs.
#include <atomic>
#include <string_view>

#include "tile.hpp"

namespace adit::sim {

extern const ShadeKernels kShade_plain;
#ifdef ADIT_SHADE_X86
extern const ShadeKernels kShade_avx2;
extern const ShadeKernels kShade_avx512;
#endif

namespace {

std::vector<const ShadeKernels*> possible() {
  std::vector<const ShadeKernels*> list = {&kShade_plain};
#ifdef ADIT_SHADE_X86
  if (__builtin_cpu_supports("avx2")) list.push_back(&kShade_avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    list.push_back(&kShade_avx512);
#endif
  return list;
}

std::atomic<const ShadeKernels*> chosen{nullptr};

}  // namespace

std::vector<const char*> shade_targets() {
  std::vector<const char*> names;
  for (const ShadeKernels* k : possible()) names.push_back(k->target);
  return names;
}

bool choose_shade_target(std::string_view name) {
  for (const ShadeKernels* k : possible())
    if (name == k->target) {
      chosen = k;
      return true;
    }
  return false;
}

const ShadeKernels& shade_kernels() noexcept {
  if (const ShadeKernels* k = chosen.load(std::memory_order_relaxed)) return *k;
  static const ShadeKernels* const best = possible().back();
  return *best;
}

}  // namespace adit::sim
