// Which build of the shading loops this CPU runs.
#include "tile.hpp"

namespace adit::sim {

extern const ShadeKernels kShade_plain;
#ifdef ADIT_SHADE_X86
extern const ShadeKernels kShade_avx2;
extern const ShadeKernels kShade_avx512;
#endif

const ShadeKernels& shade_kernels() noexcept {
#ifdef ADIT_SHADE_X86
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    return kShade_avx512;
  if (__builtin_cpu_supports("avx2")) return kShade_avx2;
#endif
  return kShade_plain;
}

}  // namespace adit::sim
