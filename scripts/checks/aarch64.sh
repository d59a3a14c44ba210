#!/usr/bin/env bash
# The core cross-compiled for 64-bit ARM; its tests run under qemu.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export ADIT_TEST_GRID=small
build_preset aarch64
file=$(find build/aarch64 -name libadit_core.a)
aarch64-linux-gnu-objdump -f "$file" | grep -m 1 -q 'elf64-littleaarch64'
run_ctest build/aarch64
