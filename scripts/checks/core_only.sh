#!/usr/bin/env bash
# The core alone, by g++ and by clang++: needs the standard library and nothing else.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"

# Every file that the compiler opened for src/ is the project's own or the toolchain's.
check_includes() {
  local folder=$1 foreign
  foreign=$(ninja -C "$folder" -t deps | awk '
      /^[^ ]/ { ours = $1 ~ /^src\// }
      /^ / && ours { print $1 }' | sort -u |
    xargs -r realpath -m --relative-base="$PWD" |
    grep -vE '^(src|include)/|^/usr/(include/(c\+\+|x86_64-linux-gnu|aarch64-linux-gnu)|lib/(gcc|llvm)|lib/clang)' |
    grep -vE '^/usr/include/(linux|asm|asm-generic)/|^/usr/include/[a-z_]+\.h$' || true)
  if [ -n "$foreign" ]; then
    printf 'the core includes what is neither its own nor the standard library:\n%s\n' "$foreign" >&2
    return 1
  fi
  tally 1 0 0
}

for preset in core-only core-only-clang; do
  build_preset "$preset" -DCMAKE_DISABLE_FIND_PACKAGE_OpenCV=ON
  check_includes "build/$preset"
  run_ctest "build/$preset"
done
