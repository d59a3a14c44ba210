#!/usr/bin/env bash
# What runs on several threads, under the thread sanitizer.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export TSAN_OPTIONS=suppressions=$PWD/scripts/checks/tsan.supp:ignore_noninstrumented_modules=1:halt_on_error=1
export ADIT_TEST_GRID=small
build_preset tsan
run_ctest build/tsan -R '[Jj]obs|[Tt]hread|[Pp]arallel'
