#!/usr/bin/env bash
# The docs site builds without a broken link or anchor, every command it shows runs, and so does the demo.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
scripts/docs
tally 1 0 0

build_preset release -DADIT_SIM=ON
rm -rf out/demo
if python3 scripts/docs_commands.py build/release/adit README.md CONTRIBUTING.md data/README.md docs/*.md \
  ros/README.md ros/*/README.md gz/README.md; then
  tally 1 0 0
else
  tally 0 1 0
  exit 1
fi

# What README's first command, which was among them, has left of the clip, as in a fresh clone.
for left in headings.csv headings.mp4 explain.png flight/fig3.png flight/fig4.png flight/flight.csv flight/flight.mp4; do
  if [ ! -s "out/demo/$left" ]; then
    echo "scripts/demo left no out/demo/$left"
    tally 0 1 0
    exit 1
  fi
done
tally 1 0 0
