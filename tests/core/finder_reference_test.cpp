// The whole chain against the plain one, on made frames.
#include <gtest/gtest.h>

#include "adit/finder.hpp"
#include "as_reference.hpp"
#include "chain_reference.hpp"
#include "frames.hpp"

namespace adit {
namespace {

using test::Frame;

void expect_as_reference(const Frame& frame, const FinderConfig& config) {
  const OpenSpace seen = OpenSpaceFinder(config).find(frame.view());
  const reference::Answer answer =
      reference::judge(frame.view(), config, config.patch_size_px, config.structuring_element_size_px);
  test::expect_same_answer(seen, answer);
}

TEST(FinderReference, MadeFrames) {
  std::mt19937 random(31);
  for (unsigned seed = 0; seed < 40; ++seed) {
    const int width = test::between(random, 16, 150);
    const int height = test::between(random, 16, 110);
    const test::Tunnel tunnel{.width = width,
                              .height = height,
                              .u_px = double(test::between(random, 0, width)),
                              .v_px = double(test::between(random, 0, height)),
                              .darkest = test::between(random, 0, 60),
                              .brightest = test::between(random, 20, 250),
                              .noise = test::between(random, 0, 40),
                              .seed = seed};
    FinderConfig config = paper_preset();
    config.patch_size_px = 1 + 2 * test::between(random, 0, 8);
    config.structuring_element_size_px = 1 + 2 * test::between(random, 0, 8);
    config.omega = 0.01 * test::between(random, 30, 100);
    config.scattering_coefficient = 0.1 * test::between(random, 1, 30);
    config.cluster_count = test::between(random, 2, 14);
    config.atmospheric_light_fraction = 0.001 * test::between(random, 1, 30);
    SCOPED_TRACE(seed);
    expect_as_reference(seed % 2 == 0 ? test::coloured_tunnel(tunnel) : test::tunnel(tunnel), config);
  }
}

TEST(FinderReference, NoiseInEveryFormat) {
  for (unsigned seed = 0; seed < 18; ++seed) {
    FinderConfig config = paper_preset();
    config.patch_size_px = 1 + 2 * static_cast<int>(seed % 3);
    config.structuring_element_size_px = 1 + 2 * static_cast<int>(seed % 4);
    config.grey16_depth_bits = 10 + static_cast<int>(seed % 7);
    SCOPED_TRACE(seed);
    expect_as_reference(test::noise(61, 45, static_cast<PixelFormat>(seed % 6), seed), config);
  }
}

}  // namespace
}  // namespace adit
