// Seeded noise: integer hashes, gradient noise and facets. The same bits on every machine that keeps IEEE floats.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

namespace adit::sim {

/// A 32-bit finaliser in which every input bit moves every output bit.
inline std::uint32_t mixed(std::uint32_t x) noexcept {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

inline std::uint32_t hash_of(int x, int y, int z, std::uint32_t seed) noexcept {
  const auto ux = static_cast<std::uint32_t>(x);
  const auto uy = static_cast<std::uint32_t>(y);
  const auto uz = static_cast<std::uint32_t>(z);
  return mixed(ux * 0x9e3779b1u ^ mixed(uy * 0x85ebca77u ^ mixed(uz * 0xc2b2ae3du ^ seed)));
}

/// [0, 1).
inline float unit_of(std::uint32_t hash) noexcept { return static_cast<float>(hash >> 8) * (1.0f / 16777216.0f); }
/// [-1, 1).
inline float signed_unit_of(std::uint32_t hash) noexcept { return 2.0f * unit_of(hash) - 1.0f; }

/// Numbers in a row from one seed.
class SeededRow {
 public:
  explicit SeededRow(std::uint32_t seed) noexcept : state_(mixed(seed ^ 0x5bd1e995u)) {}
  std::uint32_t next() noexcept {
    state_ += 0x9e3779b9u;
    return mixed(state_);
  }
  float uniform(float low, float high) noexcept { return low + (high - low) * unit_of(next()); }
  double uniform(double low, double high) noexcept { return low + (high - low) * unit_of(next()); }
  bool chance(double probability) noexcept { return unit_of(next()) < probability; }

 private:
  std::uint32_t state_;
};

/// Gradient noise (Perlin 2002), about -1 to 1, features of size 1.
[[nodiscard]] float gradient_noise(const Eigen::Vector3f& p, std::uint32_t seed) noexcept;

/// Rock that breaks along planes: space is cut into Voronoi cells of about `size`, and each cell has a displacement
/// of its own that is linear in space, so that a wall cut through it shows tilted flat faces with steps between.
/// Features are made once for a box; the value at a point does not depend on the box.
class Facets {
 public:
  Facets(float size_m, float depth_m, std::uint32_t seed) noexcept : size_(size_m), depth_(depth_m), seed_(seed) {}

  /// Makes the features for all points within [low, high].
  void prepare(const Eigen::Vector3f& low, const Eigen::Vector3f& high);
  /// Displacement in metres, about -1.5 to 1.5 times the depth.
  [[nodiscard]] float at(const Eigen::Vector3f& p) const noexcept;

 private:
  struct Feature {
    Eigen::Vector3f centre;
    Eigen::Vector3f slope;
    float offset;
  };
  [[nodiscard]] Feature feature_of(const Eigen::Vector3i& cell) const noexcept;
  [[nodiscard]] float displacement_of(const Feature& feature, const Eigen::Vector3f& p) const noexcept;

  float size_;
  float depth_;
  std::uint32_t seed_;
  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();
  Eigen::Vector3i count_ = Eigen::Vector3i::Zero();
  std::vector<Feature> features_;
};

}  // namespace adit::sim
