#!/usr/bin/env bash
# All unit tests but the simulator's (phase asan_sim) under the address and undefined-behaviour sanitizers.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
under_sanitizers
build_preset asan -DADIT_SIM=OFF
run_ctest build/asan
