#!/usr/bin/env bash
# Other projects can use adit: installed and found, or included as a folder; nothing of our flags leaks.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
build_preset release -DADIT_SIM=ON
run_ctest build/release -L package
