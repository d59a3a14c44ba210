# Sourced by every phase: strict shell, the project's folder, and the few words that phases are written in.
# shellcheck shell=bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

jobs=${ADIT_JOBS:-$(nproc)}
tally_file=${ADIT_TALLY:-/dev/null}
export CTEST_OUTPUT_ON_FAILURE=1
if command -v ccache >/dev/null; then
  # Paths relative to the project, so that another clone of it finds what this one has built.
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
fi

# tally PASSED FAILED SKIPPED: adds to the sum that scripts/test prints at the end.
tally() { echo "$1 $2 $3" >> "$tally_file"; }

# quietly LOG COMMAND...: the output goes to build/LOG.log and is shown, its end, only when the command fails.
quietly() {
  local log=build/$1.log
  shift
  mkdir -p build
  if "$@" > "$log" 2>&1; then return; fi
  echo "failed: $*"
  tail -n 120 "$log"
  return 1
}

# build_preset PRESET [CMAKE ARGUMENT...]: configures and builds build/PRESET, warnings being errors. Before the call,
# build_folder=NAME puts it into build/NAME, and build_targets="A B" builds these alone.
build_preset() {
  local preset=$1 begin=$SECONDS
  local folder=${build_folder:-$preset}
  shift
  quietly "$folder-configure" cmake --preset "$preset" -B "build/$folder" -DADIT_WERROR=ON "$@"
  # shellcheck disable=SC2086 # the targets are words
  quietly "$folder-build" cmake --build "build/$folder" --parallel "$jobs" ${build_targets:+--target $build_targets}
  echo "built build/$folder in $((SECONDS - begin)) s"
}

# What the address and undefined-behaviour sanitizers are told, by which a step takes 20.
under_sanitizers() {
  export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1
  export UBSAN_OPTIONS=print_stacktrace=1
  export ADIT_TEST_GRID=small
}

# A count in the head of ctest's JUnit file.
junit_count() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }

# run_ctest FOLDER [CTEST ARGUMENT...]: runs the tests there and adds them to the sum.
run_ctest() {
  local folder=$1 status=0 junit
  shift
  junit=$PWD/$folder/junit.xml
  ctest --test-dir "$folder" --parallel "$jobs" --output-junit "$junit" --no-tests=error --timeout 600 "$@" \
    > "$folder/ctest.log" 2>&1 || status=$?
  # The list of passed tests is long and says nothing; failures, skips and the closing lines do.
  grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed |^ +Start +[0-9]+:|^test [0-9]+$|^Internal ctest|^ *$' "$folder/ctest.log" || true
  local failed skipped
  failed=$(junit_count failures "$junit")
  skipped=$(($(junit_count skipped "$junit") + $(junit_count disabled "$junit")))
  tally $(($(junit_count tests "$junit") - failed - skipped)) "$failed" "$skipped"
  return "$status"
}
