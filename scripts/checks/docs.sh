#!/usr/bin/env bash
# The docs site builds without a broken link or anchor, and every command it shows runs.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
scripts/docs
tally 1 0 0

build_preset release -DADIT_SIM=ON
if python3 scripts/docs_commands.py build/release/adit README.md CONTRIBUTING.md data/README.md docs/*.md \
  ros/README.md ros/*/README.md gz/README.md; then
  tally 1 0 0
else
  tally 0 1 0
  exit 1
fi
