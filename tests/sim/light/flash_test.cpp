// The vehicle's lamps on and off.
#include <gtest/gtest.h>

#include <cmath>

#include "adit/sim/rendered_eye.hpp"
#include "bare_rig.hpp"
#include "box.hpp"

namespace adit::sim {
namespace {

World lit_world(bool with_lamp) {
  World world = test::box_world({0, -3, 0}, {20, 3, 4}, 0.3f);
  WorldLamp lamp;
  lamp.place = {12, 1, 3.5f};
  if (with_lamp) world.lamps = {lamp};
  return world;
}

/// Two lamps, dust, light that rock sends on; all of it adds up.
RigConfig rig_in_dust() {
  RigConfig rig = rig_preset("flood_460lux");
  rig.lens.width = 96;
  rig.lens.height = 64;
  rig.dust.extinction_1_m = 0.05f;
  return rig;
}

Shot shot_with(bool lamps_on) {
  Shot shot = test::shot_at({3, 0.2f, 1});
  shot.exposure = {0.02f, 4.0f};
  shot.lamps_on = lamps_on;
  return shot;
}

TEST(Flash, LightOfTheVehicleAndOfTheWorldAddUp) {
  RenderConfig render;
  render.threads = 1;
  render.cull_fraction = 0.0f;
  const World lit = lit_world(true), dark = lit_world(false);
  Renderer both(lit, rig_in_dust(), render), own(dark, rig_in_dust(), render);
  const Radiance on = both.radiance(shot_with(true)), off = both.radiance(shot_with(false)),
                 alone = own.radiance(shot_with(true)), none = own.radiance(shot_with(false));
  double whole = 0.0, apart = 0.0, foreign = 0.0;
  for (std::size_t i = 0; i < on.green.size(); ++i) {
    whole += static_cast<double>(on.green[i]);
    foreign += static_cast<double>(off.green[i]);
    apart += std::abs(static_cast<double>(on.green[i] - off.green[i] - alone.green[i]));
    EXPECT_EQ(none.green[i], 0.0f) << "no lamp at all, and " << i << " shines";
  }
  EXPECT_GT(foreign, 0.02 * whole);
  EXPECT_LT(foreign, 0.98 * whole);
  EXPECT_LT(apart, 1e-4 * whole);
}

TEST(Flash, TheFrameWithTheLampsOffHasTheExposureOfTheOneBefore) {
  const World world = lit_world(true);
  RigConfig rig = rig_in_dust();
  rig.lamps.flash = true;
  RenderConfig render;
  render.threads = 1;
  RenderedEye eye(world, rig, render, std::make_shared<const RayScene>(world.mesh));
  EXPECT_TRUE(eye.flashes());
  VehicleState vehicle;
  vehicle.place = {3, 0.2, 1};
  float before = 0.0f;
  int changes = 0;
  for (int frame = 0; frame < 8; ++frame) {
    eye.switch_lamps(frame % 2 == 0);
    (void)eye.look(vehicle, 0.05 * frame, static_cast<std::uint64_t>(frame));
    const Exposure exposure = eye.frame().exposure;
    const float product = exposure.time_s * exposure.gain;
    if (frame % 2 == 1)
      EXPECT_EQ(product, before) << frame;
    else
      changes += product != before ? 1 : 0;
    before = product;
  }
  EXPECT_GT(changes, 2) << "exposure follows the lit frames";
}

}  // namespace
}  // namespace adit::sim
