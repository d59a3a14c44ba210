#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "adit/sim/render.hpp"
#include "box.hpp"
#include "tile.hpp"

namespace adit::sim {
namespace {

/// A tunnel with everything on: facets, two own lamps, a foreign lamp, dust, grains, movement, daylight.
World full_world() {
  World world = test::box_world({0, -3, 0}, {30, 3, 4}, 0.3f, 2u);
  world.materials[0].albedo_log_sigma = 0.4f;
  world.materials[0].facet_slope = 0.4f;
  world.materials[0].specular = 0.2f;
  world.sky_lux = 50.0f;
  WorldLamp lamp;
  lamp.place = {12, 1, 3.5f};
  world.lamps = {lamp};
  return world;
}

Shot full_shot(std::uint64_t seed) {
  Shot shot;
  shot.pose.place = {3, 0.2f, 1};
  shot.pose.velocity_m_s = {1.0f, 0.1f, 0.0f};
  shot.pose.angular_rate_rad_s = {0.1f, 0.0f, 0.6f};
  shot.exposure = {0.02f, 4.0f};
  shot.time_s = 1.25;
  shot.seed = seed;
  return shot;
}

RigConfig full_rig() {
  RigConfig rig = rig_preset("flood_460lux");
  rig.lens.width = 200;  // not a whole number of tiles
  rig.lens.height = 150;
  rig.dust.extinction_1_m = 0.08f;
  rig.dust.grains_per_m3 = 300.0f;
  return rig;
}

TEST(Repeat, TheSameShotGivesTheSameBytesOnOneTwoAndFourThreads) {
  const World world = full_world();
  RenderConfig render;
  render.threads = 1;
  Renderer one(world, full_rig(), render);
  const Frame expected = one.render(full_shot(7));
  EXPECT_EQ(one.render(full_shot(7)).bgr, expected.bgr) << "nothing is remembered from frame to frame";
  for (const int threads : {2, 4, 0}) {
    render.threads = threads;
    Renderer many(world, full_rig(), render);
    for (int i = 0; i < 3; ++i) {
      const Frame frame = many.render(full_shot(7));
      EXPECT_EQ(frame.bgr, expected.bgr) << threads << " threads";
      EXPECT_EQ(frame.range_m, expected.range_m);
    }
  }
  EXPECT_NE(one.render(full_shot(8)).bgr, expected.bgr);
}

TEST(Repeat, StripsOfJpegAreTheWholeFrame) {
  const World world = full_world();
  RigConfig rig = full_rig();
  RenderConfig render;
  for (const int height : {150, 384, 490}) {  // one strip; as many as there are threads, with and without a part block
    rig.lens.height = height;
    rig.sensor.jpeg_quality = 0;
    Frame plain = Renderer(world, rig, render).render(full_shot(5));
    for (const int quality : {10, 90, 100}) {
      std::vector<std::uint8_t> packed;
      const cv::Mat image(plain.height, plain.width, CV_8UC3, plain.bgr.data());
      cv::imencode(".jpg", image, packed, {cv::IMWRITE_JPEG_QUALITY, quality});
      const cv::Mat back = cv::imdecode(packed, cv::IMREAD_COLOR);
      const std::vector<std::uint8_t> expected(back.datastart, back.dataend);
      ASSERT_NE(expected, plain.bgr);
      rig.sensor.jpeg_quality = quality;
      for (const int threads : {1, 2, 0}) {
        render.threads = threads;
        EXPECT_EQ(Renderer(world, rig, render).render(full_shot(5)).bgr, expected)
            << height << " px, quality " << quality << ", " << threads << " threads";
      }
    }
  }
}

TEST(Repeat, EveryCpuTargetGivesTheSameBytes) {
  const World world = full_world();
  Renderer renderer(world, full_rig());
  ASSERT_TRUE(choose_shade_target("plain"));
  const Frame expected = renderer.render(full_shot(3));
  for (const char* target : shade_targets()) {
    ASSERT_TRUE(choose_shade_target(target));
    EXPECT_EQ(renderer.render(full_shot(3)).bgr, expected.bgr) << target;
  }
  EXPECT_FALSE(choose_shade_target("abacus"));
}

TEST(Repeat, ALampInSightIsBrightAndHasAHalo) {
  const World world = full_world();
  RigConfig rig = full_rig();
  rig.dust = DustConfig{};
  Renderer with(world, rig);
  World dark = world;
  dark.lamps.clear();
  Renderer without(dark, rig);
  Shot shot = full_shot(1);
  shot.pose.velocity_m_s.setZero();
  shot.pose.angular_rate_rad_s.setZero();
  const Radiance a = with.radiance(shot), b = without.radiance(shot);
  const Eigen::Vector3f p = with.camera_pose(shot.pose).inverse() * world.lamps[0].place;
  const Pixel pixel = with.camera().pixel_of(NormalisedPoint{p.x() / p.z(), p.y() / p.z()});
  const auto at = [&](int du) {
    return static_cast<std::size_t>(std::lround(pixel.v_px)) * 200 +
           static_cast<std::size_t>(std::lround(pixel.u_px) + du);
  };
  EXPECT_GT(a.green[at(0)], 100.0f * b.green[at(0)]);
  EXPECT_GT(a.green[at(4)], b.green[at(4)]);
}

}  // namespace
}  // namespace adit::sim
