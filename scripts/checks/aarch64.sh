#!/usr/bin/env bash
# The core cross-compiled for 64-bit ARM, and its unit tests under qemu.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export ADIT_TEST_GRID=small
build_preset aarch64
aarch64-linux-gnu-objdump -f "$(find build/aarch64 -name libadit_core.a)" > build/aarch64-objects.log
grep -q 'elf64-littleaarch64' build/aarch64-objects.log
run_ctest build/aarch64
