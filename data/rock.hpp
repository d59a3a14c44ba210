// The shape and the colour of the drawn tunnel's rock.
#pragma once

#include <cmath>
#include <cstdint>

namespace adit::drawn {

/// A point or direction in metres: x right, y up, z along the drift.
struct Vec {
  double x = 0.0, y = 0.0, z = 0.0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec unit(Vec a) { return a * (1.0 / length(a)); }

/// A well-mixed number in [0, 1) for a lattice point: the source of all chance here.
[[nodiscard]] double chance(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t salt);

/// Where the middle of the drift is at z, in x.
[[nodiscard]] double centre_x_m(double z_m);

/// A distance to the rock that is never longer than about the true one; negative inside the rock.
[[nodiscard]] double distance_to_rock_m(Vec p);

/// Share of the light that the rock gives back, for red, green and blue in x, y and z.
[[nodiscard]] Vec albedo(Vec p);

}  // namespace adit::drawn
