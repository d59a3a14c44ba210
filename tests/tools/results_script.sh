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
# Rows whose flights are gone keep their lines, of this method and of the other; those that were not whole do not.
cat > docs/results.md <<'EOF'
## Method `adit`

| T junction | 7 of 15 | kept |
| straight, 5 m wide | 9 of 15 | flown anew |
| Y junction | not whole: 1 of 15 seeds flown | – |
| no such row | 1 of 15 |

Frames of 160x120 px at 20 Hz.

## Method `paper`

| T junction | 3 of 15 | of the paper |
EOF
results --table || fail "no table beside kept rows: $(cat log)"
section_of() { sed -n "/^## Method .$1.\$/,/^## Method .[^$1]/p" docs/results.md; }
section_of adit | grep -qx '| T junction | 7 of 15 | kept |' || fail "a kept row is lost: $(cat docs/results.md)"
section_of adit | grep -q '^| straight, 5 m wide | 2 of 2 ' || fail "a flown row is not in the table"
if grep -q 'flown anew\|no such row\|not whole: ' docs/results.md; then fail "a line that must go is kept"; fi
section_of paper | grep -qx '| T junction | 3 of 15 | of the paper |' || fail "the other method's table is lost"
grep -q '^Kept as they stood, .*: 1 of the rows' docs/results.md || fail "the page does not say which are kept"
grep -q '^Flown by .*straight, 5 m wide' docs/results.md || fail "the page does not say who flew the others"
cp docs/results.md before
results --table
cmp -s before docs/results.md || fail "made again, the page is another: $(diff before docs/results.md)"
results --table --quick || fail "no quick table: $(cat log)"
if grep -q 'T junction' docs/results.md; then fail "a quick table kept a row of whole flights"; fi
echo "results_script: passed"
