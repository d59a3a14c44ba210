#include "frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace adit::test {

Frame::Frame(int w, int h, PixelFormat f, int fill)
    : width(w),
      height(h),
      format(f),
      bytes(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(bytes_per_pixel(f)),
            static_cast<std::uint8_t>(fill)) {}

ImageView Frame::view() const {
  return {bytes.data(), width, height, static_cast<std::ptrdiff_t>(width) * bytes_per_pixel(format), format};
}

std::uint8_t* Frame::pixel(int u, int v) {
  const auto at = static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  return bytes.data() + at * static_cast<std::size_t>(bytes_per_pixel(format));
}

const std::uint8_t* Frame::pixel(int u, int v) const { return const_cast<Frame*>(this)->pixel(u, v); }

int between(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

namespace {

double wall_level(const Tunnel& t, int u, int v) {
  const double x = (u - t.u_px) / t.width;
  const double y = (v - t.v_px) / t.height;
  const double away = std::min(1.0, 1.4 * std::hypot(x, y));
  return t.darkest + (t.brightest - t.darkest) * away * away;
}

std::uint8_t as_level(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

template <class Place>
Frame rearranged(const Frame& frame, int width, int height, Place place) {
  Frame out(width, height, frame.format);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const auto [x, y] = place(u, v);
      std::memcpy(out.pixel(u, v), frame.pixel(x, y), static_cast<std::size_t>(bytes_per_pixel(frame.format)));
    }
  }
  return out;
}

}  // namespace

Frame tunnel(const Tunnel& t) {
  Frame frame(t.width, t.height, PixelFormat::kGrey8);
  std::mt19937 random(t.seed);
  for (int v = 0; v < t.height; ++v) {
    for (int u = 0; u < t.width; ++u) {
      *frame.pixel(u, v) = as_level(wall_level(t, u, v) + between(random, 0, t.noise));
    }
  }
  return frame;
}

Frame coloured_tunnel(const Tunnel& t) {
  Frame frame(t.width, t.height, PixelFormat::kBgr8);
  std::mt19937 random(t.seed);
  constexpr double kTint[3] = {0.7, 0.9, 1.0};
  for (int v = 0; v < t.height; ++v) {
    for (int u = 0; u < t.width; ++u) {
      for (int c = 0; c < 3; ++c) {
        frame.pixel(u, v)[c] = as_level(kTint[c] * wall_level(t, u, v) + between(random, 0, t.noise));
      }
    }
  }
  return frame;
}

Frame noise(int width, int height, PixelFormat format, unsigned seed) {
  Frame frame(width, height, format);
  std::mt19937 random(seed);
  for (auto& byte : frame.bytes) byte = static_cast<std::uint8_t>(between(random, 0, 255));
  return frame;
}

Frame mirrored(const Frame& f) {
  return rearranged(f, f.width, f.height, [&f](int u, int v) { return std::pair{f.width - 1 - u, v}; });
}

Frame flipped(const Frame& f) {
  return rearranged(f, f.width, f.height, [&f](int u, int v) { return std::pair{u, f.height - 1 - v}; });
}

Frame transposed(const Frame& f) {
  return rearranged(f, f.height, f.width, [](int u, int v) { return std::pair{v, u}; });
}

Frame in_format(const Frame& grey, PixelFormat format) {
  Frame out(grey.width, grey.height, format);
  for (int v = 0; v < grey.height; ++v) {
    for (int u = 0; u < grey.width; ++u) {
      const std::uint8_t level = *grey.pixel(u, v);
      if (format == PixelFormat::kGrey16) {
        const auto value = static_cast<std::uint16_t>(level * 256 + (u * 7 + v) % 256);  // the lower bits are dropped
        std::memcpy(out.pixel(u, v), &value, sizeof value);
        continue;
      }
      const int bytes = bytes_per_pixel(format);
      for (int c = 0; c < std::min(bytes, 3); ++c) out.pixel(u, v)[c] = level;
      if (bytes == 4) out.pixel(u, v)[3] = static_cast<std::uint8_t>(u);
    }
  }
  return out;
}

Frame reordered(const Frame& bgr, PixelFormat format) {
  Frame out(bgr.width, bgr.height, format);
  const bool red_first = format == PixelFormat::kRgb8 || format == PixelFormat::kRgba8;
  for (int v = 0; v < bgr.height; ++v) {
    for (int u = 0; u < bgr.width; ++u) {
      for (int c = 0; c < 3; ++c) out.pixel(u, v)[red_first ? 2 - c : c] = bgr.pixel(u, v)[c];
      if (bytes_per_pixel(format) == 4) out.pixel(u, v)[3] = static_cast<std::uint8_t>(v);
    }
  }
  return out;
}

}  // namespace adit::test
