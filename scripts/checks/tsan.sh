#!/usr/bin/env bash
# What runs on several threads, under the thread sanitizer.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export TSAN_OPTIONS=ignore_noninstrumented_modules=1:halt_on_error=1
# The simulator is left out: its threads are those of Embree and TBB, which Debian builds without the sanitizer, so that
# what they order looks unordered. `adit run --jobs` has threads of its own.
quietly tsan-configure cmake --preset tsan -DADIT_WERROR=ON -DADIT_SIM=OFF
quietly tsan-build cmake --build build/tsan --parallel "$jobs" --target adit_program tools_tests
run_ctest build/tsan -R '^tools\.Run'
