// Made frames for the tests: the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "adit/image.hpp"

namespace adit::test {

/// A frame with pixels of its own.
struct Frame {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::kGrey8;
  std::vector<std::uint8_t> bytes;

  Frame(int w, int h, PixelFormat f, int fill = 0);
  [[nodiscard]] ImageView view() const;
  [[nodiscard]] std::uint8_t* pixel(int u, int v);
  [[nodiscard]] const std::uint8_t* pixel(int u, int v) const;
};

/// Whole numbers low..high, the same from every standard library.
[[nodiscard]] int between(std::mt19937& random, int low, int high);

/// A dark opening about (u, v) in a wall that brightens away from it, with noise; grey.
struct Tunnel {
  int width = 160;
  int height = 120;
  double u_px = 60.0;
  double v_px = 50.0;
  int darkest = 4;
  int brightest = 220;
  int noise = 6;
  unsigned seed = 1;
};
[[nodiscard]] Frame tunnel(const Tunnel& tunnel);

/// The same, the three channels each with a tint and noise of its own; BGR.
[[nodiscard]] Frame coloured_tunnel(const Tunnel& tunnel);

/// Every value anywhere: nothing a camera would send.
[[nodiscard]] Frame noise(int width, int height, PixelFormat format, unsigned seed);

[[nodiscard]] Frame mirrored(const Frame& frame);
[[nodiscard]] Frame flipped(const Frame& frame);
[[nodiscard]] Frame transposed(const Frame& frame);

/// A grey frame in another format: the same value in each channel, alpha whatever; 16-bit in the upper 8 bits.
[[nodiscard]] Frame in_format(const Frame& grey, PixelFormat format);

/// A BGR frame as another 8-bit colour format.
[[nodiscard]] Frame reordered(const Frame& bgr, PixelFormat format);

}  // namespace adit::test
