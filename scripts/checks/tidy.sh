#!/usr/bin/env bash
# clang-tidy (.clang-tidy) and cppcheck over the core.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
build_preset core-only-clang -DCMAKE_DISABLE_FIND_PACKAGE_OpenCV=ON

# Loops for another kind of machine are not compiled here, so they cannot be read here either.
mapfile -t sources < <(find src -name '*.cpp' ! -name target_neon.cpp | sort)
status=0
if printf '%s\0' "${sources[@]}" |
  xargs -0 -n 1 -P "$jobs" clang-tidy-14 --quiet -p build/core-only-clang > build/clang-tidy.log 2>&1; then
  tally 1 0 0
else
  grep -E 'warning:|error:' -A 3 build/clang-tidy.log | head -n 100
  tally 0 1 0
  status=1
fi

# Views are passed by value on purpose; tables as large as a page are filled before they are read, not twice.
if cppcheck --quiet --std=c++20 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
  -j "$jobs" -I include -I src --suppress=missingIncludeSystem \
  --suppress=passedByValue --suppress=uninitMemberVar --suppress=uninitdata src > build/cppcheck.log 2>&1; then
  tally 1 0 0
else
  cat build/cppcheck.log
  tally 0 1 0
  status=1
fi
exit $status
