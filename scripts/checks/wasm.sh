#!/usr/bin/env bash
# The core in WebAssembly and the playground's page: a video dropped on it in headless Chromium.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
build_preset release -DADIT_SIM=ON
# scripts/playground, as the docs tell readers to call it.
rm -rf build/playground
quietly playground python3 scripts/docs_commands.py --phase wasm build/release/adit docs/see.md
ls -l build/playground/adit.js
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What the program says of the same picture, and the clip in a format that Chromium plays.
for method in paper adit; do
  build/release/adit run data/tunnel.jpg --method "$method" --csv "$work/$method.csv" --quiet
done
python3 - "$work" > "$work/answers.json" <<'EOF'
import csv, json, sys
rows = {m: next(csv.DictReader(open(f"{sys.argv[1]}/{m}.csv"))) for m in ("paper", "adit")}
print(json.dumps({m: {"status": r["status"], **{k: float(r[k]) for k in ("u_px", "v_px", "azimuth_deg")}}
                  for m, r in rows.items()}))
EOF
quietly webm ffmpeg -v error -y -i data/clip.avi -vf scale=640:480 -r 60 -c:v libvpx -b:v 4M "$work/clip.webm"
quietly playwright npm ci --prefix tests/wasm --no-audit --no-fund
status=0
node tests/wasm/playground_test.mjs build/playground "$work/clip.webm" data/tunnel.jpg "$work/answers.json" \
  build/playground.png > build/playground_test.log 2>&1 || status=$?
cat build/playground_test.log
tally "$(grep -c '^ok' build/playground_test.log)" "$(grep -c '^FAILED' build/playground_test.log || true)" 0
exit $status
