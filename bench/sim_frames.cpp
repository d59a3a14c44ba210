// Frames of the simulator: milliseconds of wall and CPU by part, at two sizes, on a course of our own.
#include <benchmark/benchmark.h>

#include <cmath>

#include "adit/sim/course.hpp"
#include "adit/sim/render.hpp"

namespace {

using namespace adit::sim;

const World& s_bend() {
  static const World world = build_course(read_course(ADIT_COURSES "/s_bend.yaml"));
  return world;
}

/// @param lamps 1: all the rig's light from one lamp. @param threads 0: all.
void frames(benchmark::State& state, int width, int height, int lamps, int threads, float extinction_1_m) {
  const World& world = s_bend();
  RigConfig rig = rig_preset("flood_460lux");
  if (lamps == 1) {
    rig.lamps.lamps.resize(1);
    rig.lamps.lamps[0].lux_at_1m *= 2.0f;
  }
  rig.lens.width = width;
  rig.lens.height = height;
  rig.dust.extinction_1_m = extinction_1_m;
  RenderConfig render;
  render.threads = threads;
  Renderer renderer(world, rig, render);
  Shot shot;
  shot.pose.attitude = Eigen::AngleAxisf(world.start.yaw_rad, Eigen::Vector3f::UnitZ());
  shot.pose.velocity_m_s = shot.pose.attitude * Eigen::Vector3f(1, 0, 0);
  shot.pose.angular_rate_rad_s = {0, 0, 0.3f};
  shot.exposure = {0.025f, 12.0f};
  const Eigen::Vector3f start = world.start.place + Eigen::Vector3f(0, 0, 1);
  Frame frame;
  RenderTimes sum{};
  for (auto _ : state) {
    shot.time_s = 0.05 * static_cast<double>(shot.seed++);
    shot.pose.place = start + shot.pose.velocity_m_s * static_cast<float>(std::fmod(shot.time_s, 5.0));
    renderer.render(shot, frame);
    sum.light_ms += frame.times.light_ms;
    sum.lens_ms += frame.times.lens_ms;
    sum.sensor_ms += frame.times.sensor_ms;
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  state.counters["light_ms"] = benchmark::Counter(sum.light_ms, mean);
  state.counters["lens_ms"] = benchmark::Counter(sum.lens_ms, mean);
  state.counters["sensor_ms"] = benchmark::Counter(sum.sensor_ms, mean);
}

}  // namespace

#define ADIT_FRAMES(name, ...) \
  BENCHMARK_CAPTURE(frames, name, __VA_ARGS__)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()

ADIT_FRAMES(vga_one_lamp_dust, 640, 480, 1, 0, 0.02f);
ADIT_FRAMES(vga_one_lamp_dust_one_thread, 640, 480, 1, 1, 0.02f);
ADIT_FRAMES(vga_two_lamps_clear, 640, 480, 2, 0, 0.0f);
ADIT_FRAMES(qvga_one_lamp_dust, 320, 240, 1, 0, 0.02f);
BENCHMARK_MAIN();
