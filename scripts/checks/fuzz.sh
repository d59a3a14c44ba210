#!/usr/bin/env bash
# Each libFuzzer target for a minute (ADIT_FUZZ_SECONDS), starting from tests/fuzz/corpus.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
export ASAN_OPTIONS=detect_leaks=1
seconds=${ADIT_FUZZ_SECONDS:-60}
build_targets=fuzz_targets build_preset fuzz

# fuzz NAME: new inputs go to a folder of their own; a crash leaves its input in build/fuzz/findings.
fuzz() {
  local name=$1 begin=$SECONDS
  local corpus=build/fuzz/grown/$name findings=build/fuzz/findings/$name
  mkdir -p "$corpus" "$findings"
  local arguments=(-max_total_time="$seconds" -timeout=30 -rss_limit_mb=4096 -print_final_stats=1
    -artifact_prefix="$findings/")
  if [ -f "tests/fuzz/$name.dict" ]; then arguments+=(-dict="tests/fuzz/$name.dict"); fi
  if "build/fuzz/tests/fuzz/fuzz_$name" "${arguments[@]}" "$corpus" "tests/fuzz/corpus/$name" \
    > "build/fuzz-$name.log" 2>&1; then
    echo "fuzz_$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz-$name.log") inputs, no finding," \
      "in $((SECONDS - begin)) s"
    tally 1 0 0
  else
    grep -vE '^#[0-9]+' "build/fuzz-$name.log" | tail -n 60
    echo "fuzz_$name: FAILED; the input is in $findings"
    tally 0 1 0
    return 1
  fi
}

# As many at a time as there are processors.
status=0 running=()
for program in build/fuzz/tests/fuzz/fuzz_*; do
  if [ ! -f "$program" ] || [ ! -x "$program" ]; then continue; fi
  fuzz "${program##*/fuzz_}" &
  running+=($!)
  if [ ${#running[@]} -ge "$jobs" ]; then
    wait "${running[0]}" || status=1
    running=("${running[@]:1}")
  fi
done
for id in "${running[@]}"; do wait "$id" || status=1; done
exit $status
