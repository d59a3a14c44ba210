#!/usr/bin/env bash
# The core's unit tests under the address and undefined-behaviour sanitizers; asan does the same with all but the simulator's, asan_sim with those.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
under_sanitizers
build_folder=asan_core build_preset asan -DADIT_CORE_ONLY=ON
run_ctest build/asan_core
