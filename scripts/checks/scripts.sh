#!/usr/bin/env bash
# Shell scripts are free of shellcheck's complaints.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
mapfile -t found < <(grep -rlE '^#!.*(bash|/sh)' scripts .ci jobs)
shellcheck -x -P SCRIPTDIR "${found[@]}" scripts/checks/prelude.sh
tally 1 0 0
