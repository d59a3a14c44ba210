// Each stage by itself.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "adit/dark_channel.hpp"
#include "adit/region.hpp"
#include "scenes.hpp"

namespace adit::bench {
namespace {

void run_dark_channel(benchmark::State& state, const Scene& scene) {
  MorphologyScratch scratch = scene.scratch();
  reference::Plane out(scene.view().width, scene.view().height);
  for (auto _ : state) {
    dark_channel(scene.view(), scene.patch, 16, out.view(), scratch);
    benchmark::DoNotOptimize(out.pixels.data());
    benchmark::ClobberMemory();
  }
}

void run_atmospheric_light(benchmark::State& state, const Scene& scene) {
  const double fraction = paper_preset().atmospheric_light_fraction;
  for (auto _ : state) benchmark::DoNotOptimize(atmospheric_light(scene.view(), 16, scene.dark.view(), fraction));
}

void close_with(benchmark::State& state, const Scene& scene, const StructuringElement& element) {
  MorphologyScratch scratch;
  scratch.reserve(scene.dark.width, scene.dark.height, element);
  reference::Plane out(scene.dark.width, scene.dark.height);
  for (auto _ : state) {
    close(scene.dark.view(), element, out.view(), scratch);
    benchmark::DoNotOptimize(out.pixels.data());
    benchmark::ClobberMemory();
  }
}

void run_closing(benchmark::State& state, const Scene& scene) { close_with(state, scene, scene.element); }

/// How little the cost grows with the radius.
void run_closing_15(benchmark::State& state, const Scene& scene) {
  close_with(state, scene, StructuringElement::ellipse(15, 15));
}
void run_closing_101(benchmark::State& state, const Scene& scene) {
  close_with(state, scene, StructuringElement::ellipse(101, 101));
}

void run_histogram(benchmark::State& state, const Scene& scene) {
  for (auto _ : state) benchmark::DoNotOptimize(histogram_of(scene.closed.view()));
}

void run_moments(benchmark::State& state, const Scene& scene) {
  std::vector<std::uint32_t> columns(static_cast<std::size_t>(scene.closed.width));
  for (auto _ : state) {
    benchmark::DoNotOptimize(moments_of(scene.closed.view(), scene.clusters.last_level[0], columns));
  }
}

}  // namespace

void register_stages() {
  register_per_target("dark_channel", run_dark_channel);
  register_per_target("atmospheric_light", run_atmospheric_light);
  register_per_target("closing", run_closing);
  register_per_target("closing_15", run_closing_15);
  register_per_target("closing_101", run_closing_101);
  register_per_target("histogram", run_histogram);
  register_per_target("moments", run_moments);
}

}  // namespace adit::bench
