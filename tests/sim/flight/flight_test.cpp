#include "adit/sim/flight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <thread>

#include "adit/sim/flight_fields.hpp"
#include "adit/sim/flight_summary.hpp"
#include "bent_tunnel.hpp"
#include "stand_in.hpp"

namespace adit::sim {
namespace {

/// Twelve corners of 7.5 degrees make a bend of 90 degrees with a radius of 10 m.
World bend() {
  std::vector<Eigen::Vector3f> line = {{0, 0, 0}, {12, 0, 0}};
  for (int i = 1; i <= 12; ++i) {
    const float a = static_cast<float>(i * 7.5 * std::numbers::pi / 180.0);
    line.emplace_back(12 + 10 * std::sin(a), 10 - 10 * std::cos(a), 0.0f);
  }
  line.emplace_back(22, 30, 0);
  line.emplace_back(22, 45, 0);
  return test::bent_tunnel(line, 4.0f, 3.0f);
}

FlightSettings settings(std::uint64_t seed) {
  FlightSettings s;
  s.finder = paper_preset();
  s.seed = seed;
  s.flight.time_max_s = 60.0;
  return s;
}

struct Flown {
  FlightSummary summary;
  std::vector<double> numbers;  ///< every number that must repeat
};

Flown fly(const World& world, const RayScene& scene, const FlightSettings& s, bool blind = false) {
  test::StandIn eye(scene);
  eye.blind = blind;
  Flight flight(s, world, scene, eye);
  FlightTally tally;
  Flown flown;
  while (flight.step()) {
    tally.add(flight.row());
    const FlightRow& row = flight.row();
    for (const double x : {row.stamp_s, row.vehicle.place.x(), row.vehicle.place.y(), row.vehicle.place.z(),
                           row.vehicle.yaw_rad, row.point.sx, row.command.yaw_rate_rad_s, row.truth.clearance_m})
      flown.numbers.push_back(x);
  }
  flown.summary = tally.of(flight);
  return flown;
}

TEST(Flight, FliesThroughABendToTheGoal) {
  const World world = bend();
  const RayScene scene(world.mesh);
  const FlightSummary summary = fly(world, scene, settings(1)).summary;
  EXPECT_EQ(to_string(summary.outcome), "goal") << summary.reason;
  EXPECT_GT(summary.distance_m, 35.0);
  EXPECT_GT(summary.side_clearance_min_m, 0.5);
  EXPECT_LE(summary.clearance_min_m, summary.side_clearance_min_m + 1e-6);
  EXPECT_GT(summary.found_fraction, 0.99);
  EXPECT_EQ(summary.false_stops, 0);
  EXPECT_GT(summary.dropped_frames, 0);
  EXPECT_LT(summary.heading_error_passage_deg.median, 15.0);
  EXPECT_NEAR(summary.progress_m, summary.distance_m, 5.0);
  EXPECT_EQ(summary.bends, 1);
}

/// Every second frame is black; judged with the one before, each of them shows the way.
TEST(Flight, LampsThatFlashAreJudgedInPairs) {
  const World world = bend();
  const RayScene scene(world.mesh);
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    FlightSettings s = settings(1);
    s.finder.method = method;
    s.flight.time_max_s = 4.0;
    s.flight.drop_fraction = 0.0;
    s.flight.repeat_fraction = 0.1;
    test::StandIn eye(scene);
    eye.flash = true;
    Flight flight(s, world, scene, eye);
    int found = 0, lit = 0, rows = 0;
    while (flight.step()) {
      const FlightRow& row = flight.row();
      EXPECT_TRUE(row.delivery != Delivery::kFresh || row.lamps_on == (row.frame % 2 == 0)) << row.frame;
      found += row.status == Status::kFound ? 1 : 0;
      lit += row.lamps_on ? 1 : 0;
      ++rows;
    }
    EXPECT_GT(rows, 50);
    EXPECT_GT(found, rows * 9 / 10) << to_string(method);
    EXPECT_NEAR(lit, rows / 2, rows / 8);
  }
}

/// Settings that are changed in flight hold from the next frame on; what was flown before is not touched by them.
TEST(Flight, OtherSettingsHoldFromTheNextFrameOn) {
  const World world = bend();
  const RayScene scene(world.mesh);
  FlightSettings s = settings(4);
  s.flight.time_max_s = 6.0;
  const Flown unchanged = fly(world, scene, s);
  NavigatorConfig other{s.finder, s.heading, {}, {}, {}, {}, {}, {}};
  other.finder.method = Method::kAdit;
  test::StandIn eye(scene);
  Flight flight(s, world, scene, eye);
  constexpr int kChangeAt = 60;
  for (int row = 0; row < kChangeAt; ++row) {
    ASSERT_TRUE(flight.step());
    EXPECT_EQ(flight.row().point.sx, unchanged.numbers[static_cast<std::size_t>(8 * row + 5)]) << row;
    EXPECT_EQ(flight.row().speed_scale, 1.0);
    EXPECT_EQ(flight.navigator(), nullptr);
  }
  NavigatorConfig wrong = other;
  wrong.finder.omega = 7.0;
  EXPECT_THROW(flight.change(wrong), std::invalid_argument);
  EXPECT_EQ(flight.navigator(), nullptr) << "what is refused changes nothing";
  flight.change(other);
  ASSERT_TRUE(flight.step());
  EXPECT_NE(flight.navigator(), nullptr);
  EXPECT_EQ(flight.settings().finder.method, Method::kAdit);
  EXPECT_LT(flight.row().speed_scale, 1.0) << "the navigator begins from rest";
  int steered = 0;
  while (flight.step()) steered += flight.row().command.state == HeadingState::kSteer ? 1 : 0;
  EXPECT_GT(steered, 60);
}

TEST(Flight, TheSameSeedGivesTheSameBytesAloneAndBesideAnother) {
  const World world = bend();
  const RayScene scene(world.mesh);
  FlightSettings s = settings(3);
  s.flight.time_max_s = 5.0;
  const Flown alone = fly(world, scene, s);
  Flown first, second;
  {
    std::jthread a([&] { first = fly(world, scene, s); });
    std::jthread b([&] { second = fly(world, scene, s); });
  }
  ASSERT_EQ(alone.numbers.size(), first.numbers.size());
  EXPECT_EQ(std::memcmp(alone.numbers.data(), first.numbers.data(), alone.numbers.size() * sizeof(double)), 0);
  EXPECT_EQ(std::memcmp(alone.numbers.data(), second.numbers.data(), alone.numbers.size() * sizeof(double)), 0);
  s.seed = 4;
  const Flown other = fly(world, scene, s);
  EXPECT_NE(std::memcmp(alone.numbers.data(), other.numbers.data(),
                        std::min(alone.numbers.size(), other.numbers.size()) * sizeof(double)),
            0);
}

TEST(Flight, WithoutOpenSpaceItHoldsAndEndsAsStopped) {
  const World world = bend();
  const RayScene scene(world.mesh);
  FlightSettings s = settings(1);
  s.flight.stop_after_s = 3.0;
  const Flown flown = fly(world, scene, s, true);
  EXPECT_EQ(flown.summary.outcome, Outcome::kStopped);
  EXPECT_LT(flown.summary.distance_m, 1.5) << "gusts alone";
  EXPECT_EQ(flown.summary.found_fraction, 0.0);
  EXPECT_EQ(flown.summary.false_stops, 1);
  EXPECT_NEAR(flown.summary.duration_s, s.flight.stop_after_s, 0.2);
}

TEST(Flight, AWallWithoutSteeringIsACollision) {
  const World world = bend();
  const RayScene scene(world.mesh);
  FlightSettings s = settings(1);
  s.heading.gain_per_s = 0.0;
  const Flown flown = fly(world, scene, s);
  EXPECT_EQ(flown.summary.outcome, Outcome::kCollided);
  EXPECT_NEAR(flown.summary.clearance_min_m, s.vehicle.body_radius_m, 1e-6);
  EXPECT_NE(flown.summary.reason.find("touched rock at ("), std::string::npos);
}

TEST(Flight, TimeRunsOutAndCirclesAreSeen) {
  const World world = bend();
  const RayScene scene(world.mesh);
  FlightSettings s = settings(1);
  s.flight.time_max_s = 3.0;
  EXPECT_EQ(fly(world, scene, s).summary.outcome, Outcome::kTimeout);
  // A stuck radius larger than the flight calls any flight stuck once it is long enough.
  s.flight.time_max_s = 60.0;
  s.flight.stuck_radius_m = 50.0;
  s.flight.stuck_after_m = 5.0;
  const FlightSummary stuck = fly(world, scene, s).summary;
  EXPECT_EQ(stuck.outcome, Outcome::kStuck);
  EXPECT_NEAR(stuck.distance_m, 5.0, 0.2);
}

/// An eye that counts time by its frames' stamps, to see how old the frame behind a command is.
TEST(Flight, TheCommandComesTheDelayAfterItsFrame) {
  const World world = bend();
  const RayScene scene(world.mesh);
  for (const int delay : {0, 1, 5}) {
    FlightSettings s = settings(1);
    s.flight.camera_delay_frames = delay;
    s.flight.drop_fraction = s.flight.repeat_fraction = 0.0;
    test::StandIn eye(scene);
    Flight flight(s, world, scene, eye);
    std::int64_t first = -1;
    while (first < 0 && flight.step())
      if (flight.row().command.state == HeadingState::kSteer) first = flight.row().frame;
    EXPECT_EQ(first, delay);
  }
}

TEST(Flight, BadFieldsAreRefusedByName) {
  const World world = bend();
  const RayScene scene(world.mesh);
  test::StandIn eye(scene);
  FlightSettings s = settings(1);
  s.flight.speed_m_s = -1.0;
  EXPECT_THROW(Flight(s, world, scene, eye), std::invalid_argument);
  EXPECT_FALSE(fault_of(FlightConfig{}));
  EXPECT_FALSE(fault_of(TruthConfig{}));
  EXPECT_FALSE(fault_of(LidarConfig{}));
  EXPECT_FALSE(fault_of(ImuConfig{}));
}

TEST(Summary, PercentilesAndWilsonsInterval) {
  std::vector<double> hundred;
  for (int i = 100; i >= 1; --i) hundred.push_back(i);
  EXPECT_EQ(spread_of(hundred).median, 50.0);
  EXPECT_EQ(spread_of(hundred).p95, 95.0);
  EXPECT_TRUE(std::isnan(spread_of({}).median));
  // Newcombe (1998), table I: 81 of 263 gives 0.2553 to 0.3662; 0 of 20 gives 0 to 0.1611.
  const Rate rate = wilson_rate(81, 263);
  EXPECT_NEAR(rate.low, 0.2553, 5e-5);
  EXPECT_NEAR(rate.high, 0.3662, 5e-5);
  EXPECT_NEAR(wilson_rate(0, 20).high, 0.1611, 5e-5);
  EXPECT_NEAR(wilson_rate(0, 20).low, 0.0, 1e-12);
  EXPECT_NEAR(wilson_rate(20, 20).low, 1.0 - 0.1611, 5e-5);
}

}  // namespace
}  // namespace adit::sim
