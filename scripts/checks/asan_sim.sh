#!/usr/bin/env bash
# The simulator's unit tests under the address and undefined-behaviour sanitizers.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
under_sanitizers
build_folder=asan_sim
build_targets="adit_sim_light_tests adit_sim_world_tests adit_sim_flight_tests"
build_preset asan -DADIT_SIM=ON
run_ctest build/asan_sim/tests/sim
