#!/usr/bin/env bash
# The pages of `adit report`, `adit view` and `adit eval` in headless Chromium: load, scrub, click, live, phone, keyboard, axe-core.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
# Playwright runs on Node 20 and later; plain Debian 12 has 18.
node_major=$(node -p 'process.versions.node.split(".")[0]' 2>/dev/null || echo 0)
if [ "$node_major" -lt 20 ]; then
  echo "see: skipped: Playwright wants Node 20 or later; here is ${node_major}"
  tally 0 0 1
  exit 0
fi
build_preset release -DADIT_SIM=ON

# Playwright and axe-core by npm, as package-lock.json pins them; the browser is Debian's.
mkdir -p build/pages
cp tests/pages/* build/pages/
quietly pages-npm npm ci --prefix build/pages --no-audit --no-fund

ADIT_BROWSER=$(command -v chromium || command -v chromium-browser)
export ADIT_BROWSER ADIT_PROGRAM=$PWD/build/release/adit ADIT_SOURCE=$PWD
status=0
# One after the other: each needs the machine for itself.
timeout 900 node --test --test-concurrency=1 --test-reporter=tap build/pages/*.test.mjs > build/pages.log 2>&1 || status=$?
grep -E '^ *(ok|not ok) |^ *# (opened|[0-9]+ frames)' build/pages.log || true
count() { sed -n "s/^# $1 \([0-9]*\)$/\1/p" build/pages.log | tail -n 1; }
if [ "$status" -ne 0 ]; then tail -n 150 build/pages.log; fi
tally "$(count pass)" "$(count fail)" "$(count skipped)"
exit "$status"
