#!/usr/bin/env bash
# Everything in a release build with g++, and all unit tests.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
build_preset release -DADIT_SIM=ON
run_ctest build/release -LE package
