#!/usr/bin/env bash
# The core alone, by g++ and by clang++: needs the standard library and nothing else.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"

# Every file that the compiler opened for src/ is the project's own or comes with the compiler and the C library.
check_includes() {
  local folder=$1 root=$PWD opened foreign
  opened=$(cd "$folder" && ninja -t deps | awk '/^[^ ]/ { core = /^src\// } /^ / && core { print $1 }' |
    sort -u | xargs realpath --relative-base="$root")
  if ! grep -q '^include/adit/finder.hpp$' <<< "$opened"; then
    echo "no list of included files in $folder: is the core built by ninja?" >&2
    return 1
  fi
  foreign=$({ grep -v '^/' <<< "$opened" | grep -vE '^(src|include)/'
    grep '^/' <<< "$opened" | xargs dpkg-query -S 2>&1 |
      grep -vE '^(libc6-dev|linux-libc-dev|libstdc\+\+-|libgcc-|libclang-common-)'; } || true)
  if [ -n "$foreign" ]; then
    printf 'the core includes what is neither its own nor the standard library:\n%s\n' "$foreign" >&2
    return 1
  fi
  tally 1 0 0
}

for preset in core-only core-only-clang; do
  build_preset "$preset" -DCMAKE_DISABLE_FIND_PACKAGE_OpenCV=ON
  # Clang also lists what a __has_include merely asked for, such as libstdc++'s question for TBB.
  if [ "$preset" = core-only ]; then check_includes "build/$preset"; fi
  run_ctest "build/$preset" -LE package
done
run_ctest build/core-only -L package
