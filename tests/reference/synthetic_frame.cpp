#include "reference/synthetic_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace adit::reference {
namespace {

/// A straight gallery of square section, seen from a little left of its middle: distances in m, radii of the lamp's
/// lobe in units of the image plane.
class Gallery {
 public:
  Gallery(int width, int height, std::uint64_t seed)
      : centre_u_(0.56 * width), centre_v_(0.47 * height), focal_length_(0.65 * width), seed_(seed) {}

  [[nodiscard]] std::uint8_t level(int u, int v) const {
    const double x = (u - centre_u_) / focal_length_;
    const double y = (v - centre_v_) / focal_length_;
    const double reach_x = x < 0.0 ? kLeft_m / -x : kRight_m / std::max(x, 1e-9);
    const double reach_y = y < 0.0 ? kRoof_m / -y : kFloor_m / std::max(y, 1e-9);
    const double depth = std::min({reach_x, reach_y, kEnd_m});
    const double normal = depth == kEnd_m ? 1.0 : std::abs(reach_x < reach_y ? x : y);
    const double square = 1.0 + x * x + y * y;
    const double range = depth * std::sqrt(square);
    const double lobe = std::exp(-(x * x + y * y) / 0.5);
    const double rock = 0.6 + 0.8 * unit(hash_of(seed_, cell(x * depth), hash_of(cell(y * depth), cell(depth))));
    const double light = kLamp * lobe * rock * normal / std::sqrt(square) / (range * range);
    const double noise = 6.0 * (unit(hash_of(seed_ + 1, static_cast<std::uint64_t>(u), static_cast<std::uint64_t>(v))) +
                                unit(hash_of(seed_ + 2, static_cast<std::uint64_t>(u), static_cast<std::uint64_t>(v))));
    return static_cast<std::uint8_t>(std::clamp(255.0 * std::pow(light, 1.0 / 2.2) + noise, 0.0, 255.0));
  }

 private:
  static constexpr double kLeft_m = 2.1;
  static constexpr double kRight_m = 2.9;
  static constexpr double kRoof_m = 2.2;
  static constexpr double kFloor_m = 1.4;
  static constexpr double kEnd_m = 60.0;
  static constexpr double kLamp = 6.0;

  static double unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) / 9007199254740992.0; }
  static std::uint64_t cell(double metres) { return static_cast<std::uint64_t>(std::llround(metres * 4.0) + 100000); }

  double centre_u_;
  double centre_v_;
  double focal_length_;
  std::uint64_t seed_;
};

/// Up and down between 0 and 255.
int triangle(int position) {
  const int phase = position % 510;
  return phase < 256 ? phase : 510 - phase;
}

std::uint8_t impulse_level(int u, int v, std::uint64_t seed) {
  const std::uint64_t bits = hash_of(seed, static_cast<std::uint64_t>(u), static_cast<std::uint64_t>(v));
  const auto height = static_cast<int>(bits >> 32U) & 63;
  const int slope = 100 + triangle(u + v) / 8;
  if (bits % 97 == 0) return static_cast<std::uint8_t>(160 + height);
  if (bits % 97 == 1) return static_cast<std::uint8_t>(20 + height);
  return static_cast<std::uint8_t>(slope);
}

std::uint8_t block_level(int u, int v, std::uint64_t seed) {
  const int block_width = 1 + static_cast<int>(hash_of(seed, 1) % 23);
  const int block_height = 1 + static_cast<int>(hash_of(seed, 2) % 23);
  const auto across = static_cast<std::uint64_t>(u / block_width);
  const auto down = static_cast<std::uint64_t>(v / block_height);
  return static_cast<std::uint8_t>(hash_of(seed, across, down));
}

std::uint8_t gradient_level(int u, int v, std::uint64_t seed) {
  const int across = static_cast<int>(hash_of(seed, 3) % 4);
  const int down = static_cast<int>(hash_of(seed, 4) % 4);
  return static_cast<std::uint8_t>(triangle(across * u + down * v + static_cast<int>(seed % 251)));
}

std::uint8_t level_of(Content content, int u, int v, std::uint64_t seed) {
  switch (content) {
    case Content::kNoise:
      return static_cast<std::uint8_t>(hash_of(seed, static_cast<std::uint64_t>(u), static_cast<std::uint64_t>(v)));
    case Content::kGradient:
      return gradient_level(u, v, seed);
    case Content::kPiecewise:
      return block_level(u, v, seed);
    case Content::kImpulses:
      return impulse_level(u, v, seed);
    case Content::kFlat:
    case Content::kTunnel:
      break;
  }
  return static_cast<std::uint8_t>(hash_of(seed, 5));
}

}  // namespace

const char* to_string(Content content) {
  static constexpr const char* kNames[] = {"noise", "gradient", "flat", "piecewise", "impulses", "tunnel"};
  return kNames[static_cast<std::size_t>(content)];
}

const char* to_string(PixelFormat format) {
  static constexpr const char* kNames[] = {"grey8", "bgr8", "rgb8", "bgra8", "rgba8", "grey16"};
  return kNames[static_cast<std::size_t>(format)];
}

std::uint64_t hash_of(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  // The finaliser of splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
  std::uint64_t bits = a * 0x9e3779b97f4a7c15U + b * 0xd1342543de82ef95U + c * 0xaf251af3b0f025b5U + 1U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

Plane synthetic_plane(Content content, int width, int height, std::uint64_t seed) {
  Plane plane(width, height);
  const Gallery gallery(width, height, seed);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      plane.at(u, v) = content == Content::kTunnel ? gallery.level(u, v) : level_of(content, u, v, seed);
    }
  }
  return plane;
}

Frame::Frame(Content content, PixelFormat format, int width, int height, std::uint64_t seed, Layout layout)
    : format_(format),
      width_(width),
      height_(height),
      row_step_bytes_(static_cast<std::ptrdiff_t>(width) * bytes_per_pixel(format) + layout.padding_bytes),
      bottom_up_(layout.bottom_up),
      bytes_(static_cast<std::size_t>(row_step_bytes_ * height - layout.padding_bytes)) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) bytes_[i] = static_cast<std::uint8_t>(hash_of(seed, i, 77));
  const int step = bytes_per_pixel(format);
  const int channels = step < 3 ? 1 : 3;
  for (int channel = 0; channel < channels; ++channel) {
    const Plane plane = synthetic_plane(content, width, height, seed + 1000U * static_cast<std::uint64_t>(channel));
    for (int v = 0; v < height; ++v) {
      std::uint8_t* row = bytes_.data() + row_step_bytes_ * (bottom_up_ ? height - 1 - v : v);
      for (int u = 0; u < width; ++u) {
        if (format != PixelFormat::kGrey16) {
          row[u * step + channel] = plane.at(u, v);
          continue;
        }
        // The low byte keeps its noise.
        std::uint16_t value = 0;
        std::memcpy(&value, row + u * step, sizeof value);
        value = static_cast<std::uint16_t>((value & 255U) | static_cast<unsigned>(plane.at(u, v)) << 8U);
        std::memcpy(row + u * step, &value, sizeof value);
      }
    }
  }
}

ImageView Frame::view() const {
  const std::ptrdiff_t first_row = bottom_up_ ? row_step_bytes_ * (height_ - 1) : 0;
  return {bytes_.data() + first_row, width_, height_, bottom_up_ ? -row_step_bytes_ : row_step_bytes_, format_};
}

}  // namespace adit::reference
