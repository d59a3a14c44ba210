// CPU targets: the pixel loops are written once and compiled for several instruction sets. All give the same bits.
#pragma once

#include <span>
#include <string_view>

#include "adit/api.hpp"

namespace ADIT_API adit {

/// Names of the targets that are compiled in and that this machine can run, the fastest first:
/// some of "avx512", "avx2", "sse41", "neon", and always "plain".
[[nodiscard]] std::span<const std::string_view> supported_cpu_targets() noexcept;

/// The target in use: what use_cpu_target() chose, or else what the environment variable ADIT_TARGET names, or else
/// the first of supported_cpu_targets(). The environment is read once.
[[nodiscard]] std::string_view cpu_target() noexcept;

/// True when ADIT_TARGET is set to something that is not in supported_cpu_targets(); it is then passed over.
[[nodiscard]] bool cpu_target_request_refused() noexcept;

/// Chooses a target for all calls from now on, in all threads. False, and no change, when it is not supported.
bool use_cpu_target(std::string_view name) noexcept;

}  // namespace adit
