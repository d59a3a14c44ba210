#include "adit/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adit/sim/rig_fields.hpp"
#include "bare_rig.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
using test::bare_render;
using test::bare_rig;
using test::box_world;
using test::direction_of;
using test::shot_at;

const Vector3f kLow(-5, -2, 0), kHigh(20, 3, 4);

float range_in_box(const Vector3f& o, const Vector3f& d) {
  float t = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 3; ++k)
    if (d[k] != 0.0f) t = std::min(t, ((d[k] > 0 ? kHigh[k] : kLow[k]) - o[k]) / d[k]);
  return t;
}

/// Pixel, distortion, mount and attitude all enter the ray; the box's closed form judges them together.
TEST(RangeMap, AgreesWithTheBoxThroughADistortedLens) {
  RigConfig rig = bare_rig();
  rig.lens.k1 = -0.25f;
  rig.lens.k2 = 0.05f;
  rig.lens.p1 = 0.002f;
  rig.lens.forward_m = 0.1f;
  rig.lens.up_m = 0.05f;
  rig.lens.pitch_deg = 8.0f;
  const World world = box_world(kLow, kHigh);
  Renderer seen_by(world, rig, bare_render());
  Shot shot = shot_at({2, 0.4f, 1.2f});
  shot.pose.attitude = Eigen::AngleAxisf(0.3f, Vector3f::UnitZ()) * Eigen::AngleAxisf(0.1f, Vector3f::UnitX());
  const Frame frame = seen_by.render(shot);
  // Body: the lens looks 8 degrees up: forward (cos, 0, sin), up (-sin, 0, cos).
  const float a = 8.0f * 3.14159265f / 180.0f;
  const Vector3f origin = shot.pose.place + shot.pose.attitude * Vector3f(0.1f, 0.0f, 0.05f);
  for (int v = 0; v < frame.height; v += 13)
    for (int u = 0; u < frame.width; u += 13) {
      const Vector3f level = direction_of(seen_by.camera(), u, v);
      const Vector3f body(level.x() * std::cos(a) - level.z() * std::sin(a), level.y(),
                          level.x() * std::sin(a) + level.z() * std::cos(a));
      const Vector3f d = shot.pose.attitude * body;
      EXPECT_NEAR(frame.range_m[static_cast<std::size_t>(v * frame.width + u)], range_in_box(origin, d), 2e-3f);
    }
}

TEST(RangeMap, SaysNothingWhereRaysLeave) {
  World world = box_world(kLow, kHigh, 0.3f, 2u);  // no wall at +x
  world.sky_lux = 1000.0f;
  Renderer renderer(world, bare_rig(), bare_render());
  const Frame frame = renderer.render(shot_at({2, 0, 2}));
  const auto centre = static_cast<std::size_t>(60 * frame.width + 80);
  EXPECT_EQ(frame.range_m[centre], kRangeOfNothing_m);
  EXPECT_GT(frame.bgr[3 * centre + 1], 200) << "daylight is bright";
}

TEST(RigFields, EveryPresetIsGoodAndFaultsAreNamed) {
  for (const std::string& name : rig_preset_names()) EXPECT_EQ(fault_of(rig_preset(name)), "") << name;
  EXPECT_THROW((void)rig_preset("torch"), std::invalid_argument);
  RigConfig rig = rig_preset("flood_460lux");
  rig.dust.extinction_1_m = 0.7f;
  EXPECT_NE(fault_of(rig).find("dust.extinction_1_m is 0.7 1/m; 0 to 0.5"), std::string::npos) << fault_of(rig);
  rig = rig_preset("flood_460lux");
  rig.lamps.lamps[1].lobe_exponent = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(fault_of(rig).find("lamps[1].lobe_exponent"), std::string::npos) << fault_of(rig);
}

/// The paper's figures are on the axis of the whole rig.
TEST(RigFields, TheFloodGives460LuxAtAMetre) {
  for (const auto& [name, lux] : {std::pair{"flood_460lux", 460.0f}, std::pair{"dim_40lux", 40.0f}}) {
    float sum = 0.0f;
    for (const Lamp& lamp : rig_preset(name).lamps.lamps) sum += intensity_on_axis_cd(lamp);
    EXPECT_FLOAT_EQ(sum, lux);
  }
}

}  // namespace
}  // namespace adit::sim
