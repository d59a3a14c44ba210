#!/usr/bin/env bash
# All unit tests under the address and undefined-behaviour sanitizers.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
under_sanitizers
# The simulator is the phase asan_sim.
build_preset asan -DADIT_SIM=OFF
run_ctest build/asan
