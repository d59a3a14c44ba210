#!/usr/bin/env bash
# All unit tests under the address and undefined-behaviour sanitizers.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1
export ADIT_TEST_GRID=small
# The simulator's courses take minutes each under the sanitizers: they are judged there on request.
build_preset asan -DADIT_SIM="${ADIT_ASAN_SIM:-OFF}"
run_ctest build/asan
