#!/usr/bin/env bash
# What runs on several threads, under the thread sanitizer.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export TSAN_OPTIONS=ignore_noninstrumented_modules=1:halt_on_error=1
# The simulator is left out: its threads are those of Embree and TBB, which Debian builds without the sanitizer, so that
# what they order looks unordered. `adit run --jobs` has threads of its own.
build_targets="adit_program tools_tests" build_preset tsan -DADIT_SIM=OFF
run_ctest build/tsan -R '^tools\.Run'
