// The pictures that are measured, and how a measurement is named.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <vector>

#include "adit/cpu_target.hpp"
#include "adit/finder.hpp"
#include "adit/morphology.hpp"
#include "reference/synthetic_frame.hpp"

namespace adit::bench {

/// A frame, what the first stages make of it, and the elements that belong to its size.
struct Scene {
  std::string name;  ///< "640x480/tunnel"
  reference::Frame frame;
  StructuringElement patch;
  StructuringElement element;
  reference::Plane dark;
  reference::Plane closed;
  double atmospheric_light = 0.0;
  LevelTable scattering_depth{};
  Histogram histogram{};
  Clusters clusters;

  Scene(reference::Content content, int width, int height);
  [[nodiscard]] ImageView view() const { return frame.view(); }
  [[nodiscard]] MorphologyScratch scratch() const;
};

/// 640x480 with sizes of 15 px and 3840x2160 with 91 and 101 px; a lamp-lit tunnel and noise. Made at the first call.
[[nodiscard]] const std::vector<Scene>& scenes();

/// Registers STAGE/SCENE/TARGET for every scene and CPU target. `run` gets the benchmark's state and the scene.
template <class Run>
void register_per_target(std::string_view stage, Run run) {
  for (const Scene& scene : scenes()) {
    for (const std::string_view target : supported_cpu_targets()) {
      const std::string name = std::string(stage) + '/' + scene.name + '/' + std::string(target);
      benchmark::RegisterBenchmark(name.c_str(), [run, target, &scene](benchmark::State& state) {
        use_cpu_target(target);
        run(state, scene);
        state.SetItemsProcessed(state.iterations() * scene.view().width * scene.view().height);
      });
    }
  }
}

void register_stages();
void register_clustering();
void register_chain();
void register_opencv();

}  // namespace adit::bench
