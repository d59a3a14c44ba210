#include "adit/sim/sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bare_rig.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

using test::bare_render;
using test::bare_rig;
using test::box_world;
using test::shot_at;

/// A wall that shines evenly: no lamp, no vignetting.
struct EvenField {
  World world = box_world({-50, -100, -100}, {0, 100, 100});
  RigConfig rig = bare_rig();
  EvenField() {
    rig.lamps.lamps.clear();
    rig.lens.vignetting_exponent = 0.0f;
    rig.sensor.response_red = rig.sensor.response_blue = 1.0f;
    rig.sensor.white_red = rig.sensor.white_blue = 1.0f;
    rig.sensor.gamma = 1.0f;
    rig.sensor.adc_bits = 8;
    rig.sensor.row_noise_e = rig.sensor.pattern_noise_e = rig.sensor.response_spread_fraction = 0.0f;
    rig.sensor.full_well_e = 2000.0f;
    rig.sensor.read_noise_e = 12.0f;
    rig.sensor.converter_noise_e = 0.0f;
    rig.sensor.colour_fade_gain = 1000.0f;
  }
  /// Luminance that fills this share of the well in the exposure.
  Frame expose(float share, const Exposure& exposure, std::uint64_t seed, bool noise = true) {
    const float electrons = share * rig.sensor.full_well_e;
    world.materials[0].emission_cd_m2 =
        electrons / (electrons_per_luminance_second(rig.lens, rig.sensor) * exposure.time_s);
    RenderConfig render = bare_render();
    render.sensor_noise = noise;
    Renderer renderer(world, rig, render);
    Shot shot = shot_at({-3, 0, 0});
    shot.exposure = exposure;
    shot.seed = seed;
    return renderer.render(shot);
  }
};

/// Photon transfer: the variance of green at green places is (electrons + read^2) in numbers, plus quantisation.
TEST(Sensor, MeanAndVarianceFollowThePhotonTransferCurve) {
  EvenField field;
  for (const float share : {0.05f, 0.2f, 0.5f, 0.8f}) {
    double sum = 0.0, sum2 = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Frame frame = field.expose(share, {0.01f, 1.0f}, seed);
      for (int v = 2; v < frame.height - 2; ++v)
        for (int u = 2 + (v & 1 ? 0 : 1); u < frame.width - 2; u += 2) {  // green of red-green and green-blue rows
          const double level = frame.bgr[static_cast<std::size_t>(3 * (v * frame.width + u)) + 1];
          sum += level;
          sum2 += level * level;
          ++count;
        }
    }
    const double mean = sum / count, variance = sum2 / count - mean * mean;
    const double electrons = static_cast<double>(share) * 2000.0, per_e = 255.0 / 2000.0;
    EXPECT_NEAR(mean, electrons * per_e, 0.01 * 255 * static_cast<double>(share) + 0.15) << "share " << share;
    EXPECT_NEAR(variance, (electrons + 144.0) * per_e * per_e + 1.0 / 12.0, 0.04 * variance) << "share " << share;
  }
}

TEST(Sensor, SeedsChangeTheNoiseAndNoiseCanBeOff) {
  EvenField field;
  const Exposure exposure{0.01f, 1.0f};
  EXPECT_NE(field.expose(0.5f, exposure, 1).bgr, field.expose(0.5f, exposure, 2).bgr);
  EXPECT_EQ(field.expose(0.5f, exposure, 3).bgr, field.expose(0.5f, exposure, 3).bgr);
  const Frame clean = field.expose(0.5f, exposure, 1, false);
  for (const std::uint8_t level : clean.bgr) ASSERT_NEAR(level, 128, 1);
}

TEST(Sensor, NeighboursDoNotShareTheirNoise) {
  EvenField field;
  const Frame frame = field.expose(0.5f, {0.01f, 1.0f}, 9);
  double product = 0.0, square = 0.0;
  int count = 0;
  for (int v = 2; v < frame.height - 2; v += 2)
    for (int u = 3; u < frame.width - 4; u += 2) {
      const double a = frame.bgr[static_cast<std::size_t>(3 * (v * frame.width + u)) + 1] - 127.5;
      const double b = frame.bgr[static_cast<std::size_t>(3 * (v * frame.width + u + 2)) + 1] - 127.5;
      product += a * b;
      square += a * a;
      ++count;
    }
  EXPECT_LT(std::abs(product / square), 4.0 / std::sqrt(count));
}

TEST(AutoExposure, SettlesAtItsTargetFromBothSides) {
  const World world = box_world({-5, -2, 0}, {20, 2, 3});
  RigConfig rig = bare_rig(460.0f);
  for (const Exposure start : {Exposure{0.0002f, 1.0f}, Exposure{0.02f, 16.0f}}) {
    Renderer renderer(world, rig, bare_render());
    AutoExposure loop(rig.sensor, start);
    Shot shot = shot_at({0, 0, 1});
    Frame frame;
    for (int i = 0; i < 30; ++i) {
      shot.exposure = loop.current();
      renderer.render(shot, frame);
      loop.observe(frame.mean_level);
    }
    EXPECT_NEAR(frame.mean_level, rig.sensor.exposure_target_level, 3.0f);
  }
}

TEST(AutoExposure, KeepsItsLimitsAndStaysWhereItsSpeedIsNothing) {
  SensorConfig sensor;
  AutoExposure loop(sensor);
  for (int i = 0; i < 100; ++i) loop.observe(0.0f);
  EXPECT_FLOAT_EQ(loop.current().time_s, sensor.exposure_max_s);
  EXPECT_FLOAT_EQ(loop.current().gain, sensor.gain_max);
  for (int i = 0; i < 100; ++i) loop.observe(255.0f);
  EXPECT_FLOAT_EQ(loop.current().time_s, sensor.exposure_min_s);
  EXPECT_FLOAT_EQ(loop.current().gain, 1.0f);
  sensor.exposure_speed = 0.0f;
  AutoExposure still(sensor, {0.004f, 2.0f});
  still.observe(3.0f);
  EXPECT_FLOAT_EQ(still.current().time_s, 0.004f * 2.0f);
}

/// Spread of the green bytes at green places of the red-green rows.
double spread_of(const Frame& frame) {
  double sum = 0.0, sum2 = 0.0;
  int count = 0;
  for (int v = 2; v < frame.height - 2; v += 2)
    for (int u = 3; u < frame.width - 2; u += 2, ++count) {
      const double level = frame.bgr[static_cast<std::size_t>(3 * (v * frame.width + u)) + 1];
      sum += level;
      sum2 += level * level;
    }
  return std::sqrt(sum2 / count - sum / count * (sum / count));
}

TEST(Sensor, GainMakesTheNoiseBehindTheAmplifierSmall) {
  EvenField field;
  field.rig.sensor.read_noise_e = 0.0f;
  field.rig.sensor.converter_noise_e = 60.0f;
  // The same light, a level of 102 of 255 both times: at gain 8 from an eighth of the electrons.
  const double at_1 = spread_of(field.expose(0.4f, {0.01f, 1.0f}, 1));
  const double at_8 = spread_of(field.expose(0.05f, {0.01f, 8.0f}, 1));
  const double levels_1 = 255.0 / 2000.0, levels_8 = 8.0 * levels_1;
  EXPECT_NEAR(at_1, levels_1 * std::sqrt(800.0 + 60.0 * 60.0), 0.05 * at_1);
  EXPECT_NEAR(at_8, levels_8 * std::sqrt(100.0 + 7.5 * 7.5), 0.05 * at_8);
}

TEST(Sensor, GainTakesColourAway) {
  EvenField field;
  field.rig.sensor.white_red = 1.5f;
  field.rig.sensor.colour_fade_gain = 4.0f;
  const auto redness = [&](float share, float gain) {
    const Frame frame = field.expose(share, {0.01f, gain}, 1, false);
    const std::size_t middle = 3 * (static_cast<std::size_t>(frame.height) / 2 * frame.width + frame.width / 2);
    return static_cast<double>(frame.bgr[middle + 2]) / frame.bgr[middle + 1];
  };
  EXPECT_GT(redness(0.4f, 1.0f), 1.4);
  EXPECT_LT(redness(0.1f, 4.0f), 1.25);
}

}  // namespace
}  // namespace adit::sim
