// The whole chain, and the copy of the frame that it is measured by.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "adit/finder.hpp"
#include "scenes.hpp"

namespace adit::bench {
namespace {

void find_with(benchmark::State& state, const Scene& scene, const FinderConfig& config) {
  OpenSpaceFinder finder(config);
  finder.reserve(scene.view().width, scene.view().height);
  for (auto _ : state) benchmark::DoNotOptimize(finder.find(scene.view()));
}

void run_find(benchmark::State& state, const Scene& scene) { find_with(state, scene, paper_preset()); }

/// How little the cost grows with the radius.
void run_find_101(benchmark::State& state, const Scene& scene) {
  FinderConfig config = paper_preset();
  config.patch_size_px = 101;
  config.structuring_element_size_px = 101;
  find_with(state, scene, config);
}

void run_copy(benchmark::State& state, const Scene& scene) {
  const ImageView view = scene.view();
  const auto size = static_cast<std::size_t>(view.stride_bytes) * static_cast<std::size_t>(view.height);
  std::vector<std::uint8_t> copy(size);
  for (auto _ : state) {
    std::memcpy(copy.data(), view.data, size);
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
}

}  // namespace

void register_chain() {
  register_per_target("find", run_find);
  register_per_target("find_101", run_find_101);
  for (const Scene& scene : scenes()) {
    benchmark::RegisterBenchmark(("copy/" + scene.name).c_str(),
                                 [&scene](benchmark::State& state) { run_copy(state, scene); });
  }
}

}  // namespace adit::bench
