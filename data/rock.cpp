#include "rock.hpp"

#include <algorithm>
#include <array>

namespace adit::drawn {
namespace {

constexpr double kHalfWidth_m = 2.5;
constexpr double kHalfHeight_m = 2.1;
constexpr double kAxisAboveFloor_m = 1.5;
constexpr double kRelief_m = 0.8;  // the relief hardly reaches further into the drift
constexpr double kFine_m = 0.15;   // nor its small shapes

double smooth(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
double mix(double a, double b, double t) { return a + (b - a) * t; }

std::uint64_t mixed(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t salt) {
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL ^
                    static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FULL ^
                    static_cast<std::uint64_t>(z) * 0x165667B19E3779F9ULL ^ salt * 0xD6E8FEB86659FD93ULL;
  h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93ULL;
  h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93ULL;
  return h ^ (h >> 32);
}

/// The low 21 bits as a number in [0, 1).
double fraction(std::uint64_t bits) { return static_cast<double>(bits & 0x1FFFFF) * 0x1.0p-21; }

/// Value noise in [-1, 1], one bump a metre.
double noise(Vec p, std::uint32_t salt) {
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy), z = static_cast<std::int64_t>(fz);
  const double tx = smooth(p.x - fx), ty = smooth(p.y - fy), tz = smooth(p.z - fz);
  std::array<double, 4> edge{};
  for (int i = 0; i < 4; ++i) {
    const std::int64_t dy = i & 1, dz = i >> 1;
    edge[static_cast<std::size_t>(i)] = mix(chance(x, y + dy, z + dz, salt), chance(x + 1, y + dy, z + dz, salt), tx);
  }
  return 2.0 * mix(mix(edge[0], edge[1], ty), mix(edge[2], edge[3], ty), tz) - 1.0;
}

/// The rock breaks along planes: each cell is cut by a plane of its own, and edges are worn round. In about [-1, 1].
double facets(Vec p, std::uint32_t salt) {
  const auto x0 = static_cast<std::int64_t>(std::floor(p.x - 0.5)),
             y0 = static_cast<std::int64_t>(std::floor(p.y - 0.5)),
             z0 = static_cast<std::int64_t>(std::floor(p.z - 0.5));
  double weights = 1e-30, heights = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const std::int64_t x = x0 + (corner & 1), y = y0 + (corner >> 1 & 1), z = z0 + (corner >> 2);
    const std::uint64_t bits = mixed(x, y, z, salt);
    const double jx = fraction(bits), jy = fraction(bits >> 21), jz = fraction(bits >> 42);
    const Vec middle{static_cast<double>(x) + 0.2 + 0.6 * jx, static_cast<double>(y) + 0.2 + 0.6 * jy,
                     static_cast<double>(z) + 0.2 + 0.6 * jz};
    const Vec from = p - middle;
    const double closeness = std::max(0.0, 1.0 - 0.55 * dot(from, from));
    const double fourth = closeness * closeness * closeness * closeness;
    const double twelfth = fourth * fourth * fourth;
    const double weight = twelfth * twelfth;  // steep: the nearest cell nearly alone decides
    const Vec tilt{jy - 0.5, jz - 0.5, jx - 0.5};
    weights += weight;
    heights += weight * ((jx + jy + jz) / 1.5 - 1.0 + 1.8 * dot(tilt, from));
  }
  return heights / weights;
}

/// How far the rock stands into the drift, in metres: the large shapes ...
double coarse_relief_m(Vec p, double floor_share) {
  const double rough = 0.30 * noise(p * 0.55, 11) + 0.32 * facets(p * 0.9, 23);
  return mix(rough, 0.05 * noise(p * 1.3, 51), floor_share);
}

/// ... and the small ones, never more than kFine_m.
double fine_relief_m(Vec p, double floor_share) {
  double rough = 0.0, gravel = 0.0;
  if (floor_share < 1.0) {
    rough = 0.10 * facets(p * 2.6, 37) + 0.035 * facets(p * 7.0, 39) + 0.012 * noise(p * 19.0, 43);
  }
  if (floor_share > 0.0)
    gravel = 0.045 * facets(p * 4.0, 53) + 0.02 * facets(p * 11.0, 57) + 0.008 * noise(p * 29.0, 59);
  return mix(rough, gravel, floor_share);
}

}  // namespace

double chance(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t salt) {
  return static_cast<double>(mixed(x, y, z, salt) >> 11) * 0x1.0p-53;
}

double centre_x_m(double z_m) { return 3.4 * std::sin(z_m / 7.5) + 0.8 * std::sin(z_m / 3.1 + 1.0); }

double distance_to_rock_m(Vec p) {
  const double slope = (centre_x_m(p.z + 0.05) - centre_x_m(p.z - 0.05)) / 0.1;
  const double across = (p.x - centre_x_m(p.z)) / std::sqrt(1.0 + slope * slope);
  // A horseshoe: a superellipse cut by the floor.
  const double a = std::abs(across) / kHalfWidth_m, b = std::abs(p.y - 0.3) / kHalfHeight_m;
  const double wall = (1.0 - std::cbrt(a * a * a + b * b * b)) * kHalfHeight_m;
  const double floor = p.y + kAxisAboveFloor_m;
  const double plain = std::min(wall, floor);
  if (plain > 1.6 * kRelief_m) return 0.8 * (plain - kRelief_m);
  const double floor_share = std::clamp((wall - floor) / 0.5 + 0.5, 0.0, 1.0);
  const double blunt = std::clamp(0.5 + 0.5 * (wall - floor) / 0.4, 0.0, 1.0);
  const double rounded = mix(wall, floor, blunt) - 0.4 * blunt * (1.0 - blunt);
  const double coarse = rounded - coarse_relief_m(p, floor_share);
  if (coarse > 2.0 * kFine_m) return 0.6 * (coarse - kFine_m);
  return 0.6 * (coarse - fine_relief_m(p, floor_share));
}

Vec albedo(Vec p) {
  const double stain = noise(p * 0.8, 71) + 0.5 * noise(p * 2.1, 73);
  const double grain = 0.5 * noise(p * 9.0, 79) + 0.5 * noise(p * 25.0, 83);
  const double vein = std::clamp(1.0 - 7.0 * std::abs(noise(p * 0.45 + Vec{0.0, 3.0, 0.0}, 89)), 0.0, 1.0);
  const double level = std::clamp(0.16 * (1.0 + 0.35 * stain + 0.35 * grain) + 0.10 * vein, 0.03, 0.5);
  const double rust = std::clamp(0.5 + 0.8 * noise(p * 0.6, 97), 0.0, 1.0);
  return {level * (1.0 + 0.18 * rust), level * (1.0 + 0.02 * rust), level * (0.92 - 0.22 * rust)};
}

}  // namespace adit::drawn
