#!/usr/bin/env bash
# The core's unit tests under the address and undefined-behaviour sanitizers; asan does the same with all others.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1
export ADIT_TEST_GRID=small
begin=$SECONDS
quietly asan_core-configure cmake --preset asan -B build/asan_core -DADIT_WERROR=ON -DADIT_CORE_ONLY=ON
quietly asan_core-build cmake --build build/asan_core --parallel "$jobs"
echo "built build/asan_core in $((SECONDS - begin)) s"
run_ctest build/asan_core
