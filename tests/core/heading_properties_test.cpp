// Random sequences of frames, ticks and broken stamps: what must hold at every step.
#include <gtest/gtest.h>

#include <cmath>

#include "adit/heading.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::between;

OpenSpace random_answer(std::mt19937& random) {
  OpenSpace seen;
  seen.status = between(random, 0, 2) > 0 ? Status::kFound : static_cast<Status>(between(random, 1, kStatusCount - 1));
  seen.bearing.azimuth_rad = 0.001 * between(random, -1200, 1200);
  if (between(random, 0, 40) == 0) seen.bearing.azimuth_rad = std::nan("");
  return seen;
}

double random_stamp(std::mt19937& random, double last_s) {
  switch (between(random, 0, 15)) {
    case 0:
      return last_s;
    case 1:
      return last_s - 0.001 * between(random, 1, 400);
    case 2:
      return std::nan("");
    case 3:
      return last_s + 0.01 * between(random, 30, 300);
    case 4:
      return last_s + 1e-12 * between(random, 1, 9);
    case 5:
      return between(random, 0, 9) == 0 ? last_s - 60.0 : last_s + 0.02;
    default:
      return last_s + 0.001 * between(random, 20, 60);
  }
}

HeadingConfig random_config(std::mt19937& random) {
  HeadingConfig config;
  config.gain_per_s = 0.1 * between(random, 0, 30);
  config.yaw_rate_max_rad_s = 0.1 * between(random, 0, 20);
  config.yaw_acceleration_max_rad_s2 = 0.1 * between(random, 1, 50);
  config.dead_band_rad = 0.01 * between(random, 0, 10);
  config.hold_after_s = 0.1 * between(random, 1, 10);
  return config;
}

void expect_within_limits(const HeadingCommand& command, const HeadingConfig& config) {
  ASSERT_TRUE(std::isfinite(command.yaw_rate_rad_s));
  ASSERT_LE(std::abs(command.yaw_rate_rad_s), config.yaw_rate_max_rad_s + 1e-12);
  ASSERT_TRUE(command.state != HeadingState::kHold || command.yaw_rate_rad_s == 0.0);
}

TEST(HeadingProperties, NoStaleCommandIsRepeatedWhateverComes) {
  std::mt19937 random(41);
  for (int sequence = 0; sequence < 300; ++sequence) {
    const HeadingConfig config = random_config(random);
    HeadingController controller(config);
    double last_s = between(random, 0, 1) == 0 ? 0.0 : 1.7e9;  // as counted by a simulator or since 1970
    double rate = 0.0;
    for (int step = 0; step < 300; ++step) {
      const OpenSpace seen = random_answer(random);
      const double stamp_s = random_stamp(random, last_s);
      const bool is_tick = between(random, 0, 4) == 0;
      const HeadingCommand command = is_tick ? controller.tick(stamp_s) : controller.update(seen, stamp_s);
      expect_within_limits(command, config);
      if (HasFatalFailure()) FAIL() << "sequence " << sequence << " step " << step;
      const bool has_bearing = !is_tick && seen.found() && std::isfinite(seen.bearing.azimuth_rad);
      if (command.state == HeadingState::kSteer) {
        ASSERT_TRUE(has_bearing && std::isfinite(stamp_s));
        // Either on the wanted side of the last rate, or the wanted rate itself: never away from both.
        const double wanted = yaw_of_azimuth(seen.bearing.azimuth_rad);
        ASSERT_TRUE(std::abs(command.yaw_rate_rad_s) <= std::abs(rate) + 1e-12 || command.yaw_rate_rad_s * wanted > 0);
      } else {
        // On its way to zero: truly smaller each time, same sign, until it is zero.
        ASSERT_TRUE(command.yaw_rate_rad_s * rate >= 0.0);
        const bool hardly_apart = stamp_s > last_s && stamp_s - last_s < 1e-9;  // nothing to run down in no time
        if (!hardly_apart) {
          ASSERT_TRUE(std::abs(command.yaw_rate_rad_s) < std::abs(rate) || rate == 0.0)
              << "sequence " << sequence << " step " << step;
        } else {
          ASSERT_LE(std::abs(command.yaw_rate_rad_s), std::abs(rate));
        }
      }
      rate = command.yaw_rate_rad_s;
      if (std::isfinite(stamp_s)) last_s = stamp_s < last_s - 50.0 ? stamp_s : std::max(last_s, stamp_s);
    }
  }
}

TEST(HeadingProperties, TheChangeIsLimitedInEveryOrderlySequence) {
  std::mt19937 random(43);
  for (int sequence = 0; sequence < 200; ++sequence) {
    const HeadingConfig config = random_config(random);
    HeadingController controller(config);
    double time_s = 0.0;
    double rate = 0.0;
    for (int step = 0; step < 200; ++step) {
      const double elapsed_s = 0.001 * between(random, 1, 90);
      time_s += elapsed_s;
      const HeadingCommand command =
          between(random, 0, 3) == 0 ? controller.tick(time_s) : controller.update(random_answer(random), time_s);
      if (command.state != HeadingState::kHold) {
        ASSERT_LE(std::abs(command.yaw_rate_rad_s - rate), config.yaw_acceleration_max_rad_s2 * elapsed_s + 1e-9);
      }
      rate = command.yaw_rate_rad_s;
    }
  }
}

TEST(HeadingProperties, MirroredBearingsGiveMirroredCommands) {
  std::mt19937 random(47);
  HeadingController one;
  HeadingController other;
  double stamp_s = 0.0;
  for (int step = 0; step < 2000; ++step) {
    stamp_s = random_stamp(random, stamp_s);
    OpenSpace seen = random_answer(random);
    const HeadingCommand command = one.update(seen, stamp_s);
    seen.bearing.azimuth_rad = -seen.bearing.azimuth_rad;
    const HeadingCommand mirrored = other.update(seen, stamp_s);
    ASSERT_EQ(command.state, mirrored.state);
    ASSERT_EQ(command.yaw_rate_rad_s, -mirrored.yaw_rate_rad_s);
    if (!std::isfinite(stamp_s)) stamp_s = 0.05 * step;
  }
}

}  // namespace
}  // namespace adit
