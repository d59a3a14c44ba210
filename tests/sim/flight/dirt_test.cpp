// Dirt on the lens in closed loop: named while the vehicle turns, and never where there is none.
#include <gtest/gtest.h>

#include <memory>

#include "adit/sim/course.hpp"
#include "adit/sim/flight.hpp"
#include "adit/sim/rendered_eye.hpp"

namespace adit::sim {
namespace {

/// The S of courses/s_bend.yaml.
World s_bend() {
  CourseConfig course;
  course.width_m = 6;
  course.height_m = 4;
  PassagePlan passage;
  passage.to = "goal";
  passage.end = NodeKind::kGoal;
  Move straight, left, right;
  straight.straight_m = 6.0;
  left.turn_deg = 57.3;
  right.turn_deg = -57.3;
  left.radius_m = right.radius_m = 10.0;
  passage.moves = {straight, left, right, straight};
  course.passages = {passage};
  return build_course(course);
}

struct Flown {
  Outcome outcome = Outcome::kTimeout;
  double named_s = -1.0;
};

Flown fly(const World& world, const std::shared_ptr<const RayScene>& scene, const DirtConfig& dirt) {
  RigConfig rig = rig_preset("flood_460lux");
  rig.lens.width = 160;
  rig.lens.height = 120;
  rig.dirt = dirt;
  RenderedEye eye(world, rig, {}, scene);
  FlightSettings settings;
  settings.flight.time_max_s = 60.0;
  Flight flight(settings, world, *scene, eye);
  Flown flown;
  while (flight.step())
    if (flown.named_s < 0.0 && flight.open_space().flags.dirty_lens) flown.named_s = flight.row().stamp_s;
  flown.outcome = flight.outcome().value();
  return flown;
}

TEST(Dirt, IsNamedInAnSBendAndNobodyTouchesRock) {
  const World world = s_bend();
  const auto scene = std::make_shared<const RayScene>(world.mesh);
  const Flown dirty = fly(world, scene, {.spots = 1, .azimuth_deg = -14.0f, .elevation_deg = -3.0f});
  EXPECT_EQ(to_string(dirty.outcome), "goal");
  EXPECT_GT(dirty.named_s, 3.0);
  EXPECT_LT(dirty.named_s, 25.0);
  const Flown clean = fly(world, scene, {});
  EXPECT_EQ(to_string(clean.outcome), "goal");
  EXPECT_EQ(clean.named_s, -1.0);
}

}  // namespace
}  // namespace adit::sim
