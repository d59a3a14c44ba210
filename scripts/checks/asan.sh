#!/usr/bin/env bash
# All unit tests under the address and undefined-behaviour sanitizers.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
under_sanitizers
# The simulator's courses take minutes each under the sanitizers: they are judged there on request.
build_preset asan -DADIT_SIM="${ADIT_ASAN_SIM:-OFF}"
run_ctest build/asan
