#!/usr/bin/env bash
# 1,000 short flights as an array on a real Slurm on loopback, one node killed midway, the rest run again: same bytes.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
# shellcheck source=scripts/slurm/loopback.sh
. scripts/slurm/loopback.sh

flights=${ADIT_SLURM_FLIGHTS:-1000} shards=20
if [ "$(id -u)" -ne 0 ]; then
  echo "skipped: a Slurm of our own needs root here"
  tally 0 0 1
  exit 0
fi
build_preset release -DADIT_SIM=ON
adit=$PWD/build/release/adit
work=$(mktemp -d)
chmod 755 "$work"
trap 'loopback_down; rm -rf "$work"' EXIT
loopback_up "$work/slurm"

# What is tested is the joining, not the flying: tiny frames, tiny time, a tiny drift of coarse rock.
cat > "$work/tiny.yaml" <<'EOF'
about: A short drift in coarse rock, for many flights.
passages:
  - to: goal
    end: goal
    moves:
      - {straight_m: 12}
EOF
fly=(fly "$work/tiny.yaml" --runs "$flights" --quiet --method paper --time 0.2 --set course.cell_m=0.5
  --set lens.width=32 --set lens.height=24 --set flight.camera_rate_hz=10 --set lidar.lidar_rays=8)
submit() {  # TASKS: one job, its number on standard output
  ADIT=$adit sbatch --parsable --chdir="$work" --output="$work/log-%a" --array="$1" "$PWD/jobs/slurm_array.sbatch" \
    "$shards" "${fly[@]}" --out "$work/array"
}
wait_for() {  # JOB SECONDS
  local begin=$SECONDS
  while [ -n "$(squeue -h -j "$1" 2>/dev/null)" ]; do
    if [ $((SECONDS - begin)) -gt "$2" ]; then
      squeue
      tail -n 5 "$work"/log-* "$work"/slurm/log/*
      echo "job $1 did not end in $2 s" >&2
      return 1
    fi
    sleep 0.5
  done
}
parts() { find "$work/array" -name 'runs.part-*-of-*' 2>/dev/null | wc -l; }

begin=$SECONDS
job=$(submit "1-$shards")
# Midway: some parts are there, and a task on the second node stands still in the midst of its work, so that its part is
# sure to be lost.
lost=
for _ in $(seq 600); do
  if [ "$(parts)" -ge 4 ]; then
    lost=$(loopback_node_halts 2)
    if [ -n "$lost" ] && [ ! -e "$work/array/runs.part-$lost-of-$shards" ]; then break; fi
    loopback_node_goes_on 2
    lost=
  fi
  sleep 0.1
done
if [ -z "$lost" ]; then
  echo "no task was caught at work on node n2; $(parts) of $shards parts are there" >&2
  exit 1
fi
before=$(parts)
loopback_node_dies 2
echo "node n2 killed with $before of $shards parts there, in the midst of task $lost"
# The node is given up after SlurmdTimeout, and what ran there with it; the other goes on.
wait_for "$job" 600
missing=$("$adit" merge "$work/array" --missing)
if "$adit" merge "$work/array" --quiet 2> "$work/refusal"; then
  echo "task $lost was lost (missing: $missing), but the parts were joined" >&2
  exit 1
fi
cat "$work/refusal"
grep -q 'missing' "$work/refusal"
loopback_node_up 2
job=$(submit "$missing")
wait_for "$job" 600
"$adit" merge "$work/array" > "$work/table"
tail -n 1 "$work/table"
echo "$flights flights in $shards tasks, one node killed, tasks $missing run again: $((SECONDS - begin)) s"
tally 1 0 0

begin=$SECONDS
"$adit" "${fly[@]}" --out "$work/whole" --jobs "$jobs"
echo "the same on one machine without Slurm: $((SECONDS - begin)) s"
for table in runs.csv runs.json; do cmp "$work/whole/$table" "$work/array/$table"; done
[ "$(wc -l < "$work/array/runs.csv")" = $((flights + 1)) ]
# summary.json tells how long a flight took, made_by.json with which command it was made.
# What was killed may leave a hidden file that it was still writing.
diff -rq --exclude='runs.part-*' --exclude=summary.json --exclude=made_by.json --exclude='.*.part-*' "$work/whole" \
  "$work/array"
tally 2 0 0

# What docs/scale.md shows, by the same Slurm and by GNU parallel.
begin=$SECONDS
quietly slurm-docs python3 scripts/docs_commands.py --phase slurm "$adit" docs/scale.md
echo "$(tail -n 1 build/slurm-docs.log) ($((SECONDS - begin)) s)"
tally 1 0 0

# GNU parallel, by the same parts; a part that is lost is made again.
if command -v parallel >/dev/null; then
  fly_few=("${fly[@]}")
  fly_few[3]=40
  ADIT=$adit quietly parallel jobs/parallel.sh 4 "$work/parallel" "${fly_few[@]}" --out "$work/parallel"
  rm "$work/parallel/runs.part-3-of-4" "$work/parallel/runs.csv"
  ADIT=$adit quietly parallel jobs/parallel.sh 4 "$work/parallel" "${fly_few[@]}" --out "$work/parallel"
  cmp "$work/parallel/runs.csv" <(head -n 41 "$work/whole/runs.csv")
  tally 1 0 0
fi

loopback_down
leftovers=$(pgrep -af "$work" | grep -v "^$$ " || true)
if [ -n "$leftovers" ]; then
  printf 'left running:\n%s\n' "$leftovers" >&2
  exit 1
fi
tally 1 0 0
