#!/usr/bin/env bash
# C++ sources are formatted as .clang-format says.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
git ls-files -z '*.cpp' '*.hpp' '*.h' '*.inc' | xargs -0 -r clang-format-14 --dry-run --Werror
tally 1 0 0
