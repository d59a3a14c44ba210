#!/usr/bin/env bash
# Dockerfile and devcontainer: dockerfilelint has no complaint, and what they copy and name is there. Nothing is built.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
mkdir -p build/docker
cp tests/docker/package.json tests/docker/package-lock.json build/docker/
quietly docker-npm npm ci --prefix build/docker --no-audit --no-fund
lint=build/docker/node_modules/.bin/dockerfilelint

# A linter that finds nothing in this has stopped looking.
printf 'FROM debian:latest\nRUN sudo apt-get update\nCOPY a b c\nEXPOSE 99999999\n' > build/docker/Faulty
if "$lint" build/docker/Faulty > build/docker/faulty.log 2>&1; then
  echo "docker: dockerfilelint took a faulty file for a good one"
  tally 0 1 0
  exit 1
fi
tally 1 0 0

status=0
for file in Dockerfile .devcontainer/Dockerfile; do
  if quietly docker-lint "$lint" "$file" && python3 tests/docker/sources_of.py "$file"; then tally 1 0 0; else tally 0 1 0; status=1; fi
done
if python3 tests/docker/devcontainer.py .devcontainer/devcontainer.json; then tally 1 0 0; else tally 0 1 0; status=1; fi
exit "$status"
