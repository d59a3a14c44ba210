// Benchmarks of the stages, the chain and their OpenCV equivalents (Google Benchmark).
//
//   cmake -S . -B build && cmake --build build --target adit_benchmarks
//   build/bench/adit_benchmarks --benchmark_filter='find/640x480|copy/640x480'
//
// Names are STAGE/SIZE/CONTENT[/CPU TARGET]; --benchmark_list_tests lists them, and the filter is a regular expression.
// Patch and element are scaled with the frame (15 px at 640x480, 91 px at 3840x2160); _15 and _101 fix them.
// For figures to quote: an idle machine, --benchmark_repetitions=9 --benchmark_report_aggregates_only=true (take the
// median), and `taskset -c 1` before the command so that the work stays on one core. All of it takes several minutes.
// Debian builds the library with assertions and it warns of that: it costs a few ns a loop, not more.
#include <benchmark/benchmark.h>

#include <string>

#include "scenes.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::AddCustomContext("cpu_target", std::string(adit::cpu_target()));
  adit::bench::register_chain();
  adit::bench::register_stages();
  adit::bench::register_clustering();
  adit::bench::register_opencv();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
