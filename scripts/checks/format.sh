#!/usr/bin/env bash
# C++ sources are formatted as .clang-format says.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
find . \( -path './build*' -o -path './.git' \) -prune -o -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.inc' \) \
  -print0 | xargs -0 clang-format-14 --dry-run --Werror
tally 1 0 0
