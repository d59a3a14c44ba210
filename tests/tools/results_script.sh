#!/usr/bin/env bash
# scripts/results never deletes what was flown, and its page names the whole command. Usage: results_script.sh SOURCE
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r "$1/scripts" "$scratch/scripts"
mkdir -p "$scratch/docs/figures"
cd "$scratch"
# A program that flies at once.
cat > adit <<'EOF'
#!/usr/bin/env bash
if [ "$1" = --version ]; then echo "adit ${STAND_IN_VERSION:-1}"; exit 0; fi
while [ $# -gt 0 ]; do if [ "$1" = --out ]; then out=$2; fi; shift; done
mkdir -p "$out"
printf '{\n  "runs": 2,\n  "successes": 2,\n  "success_rate_low": 0.3,\n  "success_rate_high": 1\n}\n' > "$out/runs.json"
EOF
chmod +x adit
export ADIT=$scratch/adit ADIT_DATA=/nonexistent
fail() { echo "results_script: $*" >&2; exit 1; }
results() { scripts/results --method adit --work work "$@" > log 2>&1; }

results --size 160x120 --seeds 2 straight || fail "the row was not flown: $(cat log)"
row=work/adit/straight
echo mine > "$row/kept"
results --size 160x120 --seeds 2 straight || fail "the same again must do nothing"
if results straight; then fail "another size must be refused"; fi
grep -q "left alone: $row" log || fail "and said: $(cat log)"
if results --size 160x120 --seeds 3 straight; then fail "other seeds must be refused"; fi
if STAND_IN_VERSION=2 results --size 160x120 --seeds 2 straight; then fail "another program must be refused"; fi
[ -f "$row/kept" ] || fail "a flown row was deleted"
# A mark of before programs were noted.
rm "$row/program"
STAND_IN_VERSION=2 results --size 160x120 --seeds 2 straight || fail "a row without a program must still be read"
[ -f "$row/kept" ] || fail "a row without a program was deleted"
# Half a row that somebody is flying, with a script that left no note of it.
mkdir -p work/adit/slope/seed_1
echo '{}' > work/adit/slope/seed_1/summary.json
if results --size 160x120 --seeds 2 slope; then fail "half a row of others must be left alone"; fi
[ -f work/adit/slope/seed_1/summary.json ] || fail "half a row of others was deleted"
# One of our own is flown anew.
cp "$row/begun" work/adit/slope/begun
sed -i 's/straight --time 120/slope --time 150/; s/adit 2/adit 1/' work/adit/slope/begun
results --size 160x120 --seeds 2 slope || fail "half a row of ours must be flown anew: $(cat log)"
results --table || fail "no table: $(cat log)"
grep -q -- '--method adit --size 160x120 --seeds 2` flies them' docs/results.md || fail "the page has not the whole command"
grep -q 'Frames of 160x120 px' docs/results.md || fail "the page tells a size that was not flown"
echo "results_script: passed"
