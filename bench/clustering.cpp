// Clustering works on 256 bins: its cost depends on the levels in use, not on the frame's size or the CPU target.
#include <cstdint>

#include "adit/kmeans.hpp"
#include "scenes.hpp"

namespace adit::bench {

void register_clustering() {
  for (const Scene& scene : scenes()) {
    benchmark::RegisterBenchmark(("clusters_exact/" + scene.name).c_str(), [&scene](benchmark::State& state) {
      for (auto _ : state) {
        benchmark::DoNotOptimize(cluster_exact(scene.scattering_depth, scene.histogram, paper_preset().cluster_count));
      }
    });
    benchmark::RegisterBenchmark(("clusters_lloyd/" + scene.name).c_str(), [&scene](benchmark::State& state) {
      const FinderConfig config = paper_preset();
      const LloydSettings settings{static_cast<std::uint64_t>(config.lloyd_seed), config.lloyd_starts,
                                   config.lloyd_iterations_max, config.lloyd_tolerance};
      for (auto _ : state) {
        benchmark::DoNotOptimize(
            cluster_lloyd(scene.scattering_depth, scene.histogram, config.cluster_count, settings));
      }
    });
  }
}

}  // namespace adit::bench
