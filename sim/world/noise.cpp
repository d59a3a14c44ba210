#include "noise.hpp"

#include <algorithm>
#include <limits>

namespace adit::sim {
namespace {

/// Dot product with one of the twelve edge directions of a cube.
float gradient_dot(std::uint32_t hash, float x, float y, float z) noexcept {
  const std::uint32_t h = hash & 15u;
  const float u = h < 8 ? x : y;
  const float v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
  return ((h & 1u) ? -u : u) + ((h & 2u) ? -v : v);
}

float fade(float t) noexcept { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }
float mix(float a, float b, float t) noexcept { return a + (b - a) * t; }

Eigen::Vector3i cell_of(const Eigen::Vector3f& p, float size) noexcept {
  return {static_cast<int>(std::floor(p.x() / size)), static_cast<int>(std::floor(p.y() / size)),
          static_cast<int>(std::floor(p.z() / size))};
}

/// Width of the bevel between two facets, as a share of their size: broken edges are not razor sharp.
constexpr float kBevel = 0.10f;

}  // namespace

float gradient_noise(const Eigen::Vector3f& p, std::uint32_t seed) noexcept {
  const float fx = std::floor(p.x());
  const float fy = std::floor(p.y());
  const float fz = std::floor(p.z());
  const int ix = static_cast<int>(fx);
  const int iy = static_cast<int>(fy);
  const int iz = static_cast<int>(fz);
  const float x = p.x() - fx;
  const float y = p.y() - fy;
  const float z = p.z() - fz;
  const float u = fade(x);
  const float v = fade(y);
  float plane[2];
  for (int k = 0; k < 2; ++k) {
    float line[2];
    for (int j = 0; j < 2; ++j) {
      const float yj = y - static_cast<float>(j);
      const float zk = z - static_cast<float>(k);
      const float near = gradient_dot(hash_of(ix, iy + j, iz + k, seed), x, yj, zk);
      const float far = gradient_dot(hash_of(ix + 1, iy + j, iz + k, seed), x - 1.0f, yj, zk);
      line[j] = mix(near, far, u);
    }
    plane[k] = mix(line[0], line[1], v);
  }
  return mix(plane[0], plane[1], fade(z));
}

Facets::Feature Facets::feature_of(const Eigen::Vector3i& cell) const noexcept {
  SeededRow row(hash_of(cell.x(), cell.y(), cell.z(), seed_));
  Feature feature;
  const Eigen::Vector3f jitter(row.uniform(0.05f, 0.95f), row.uniform(0.05f, 0.95f), row.uniform(0.05f, 0.95f));
  feature.centre = (cell.cast<float>() + jitter) * size_;
  const float tilt = 1.6f * depth_ / size_;
  feature.slope = Eigen::Vector3f(row.uniform(-tilt, tilt), row.uniform(-tilt, tilt), row.uniform(-tilt, tilt));
  feature.offset = row.uniform(-depth_, depth_);
  return feature;
}

void Facets::prepare(const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  first_ = cell_of(low, size_) - Eigen::Vector3i::Ones();
  count_ = cell_of(high, size_) + Eigen::Vector3i::Constant(2) - first_;
  features_.clear();
  features_.reserve(static_cast<std::size_t>(count_.prod()));
  for (int z = 0; z < count_.z(); ++z)
    for (int y = 0; y < count_.y(); ++y)
      for (int x = 0; x < count_.x(); ++x) features_.push_back(feature_of(first_ + Eigen::Vector3i(x, y, z)));
}

float Facets::displacement_of(const Feature& feature, const Eigen::Vector3f& p) const noexcept {
  const float value = feature.offset + feature.slope.dot(p - feature.centre);
  return std::clamp(value, -1.5f * depth_, 1.5f * depth_);
}

float Facets::at(const Eigen::Vector3f& p) const noexcept {
  const Eigen::Vector3i cell = cell_of(p, size_) - first_;
  float nearest = std::numeric_limits<float>::max();
  float second = nearest;
  const Feature* first_feature = nullptr;
  const Feature* second_feature = nullptr;
  for (int z = cell.z() - 1; z <= cell.z() + 1; ++z) {
    for (int y = cell.y() - 1; y <= cell.y() + 1; ++y) {
      const Feature* row = &features_[static_cast<std::size_t>((z * count_.y() + y) * count_.x() + cell.x() - 1)];
      for (int i = 0; i < 3; ++i) {
        const float distance = (row[i].centre - p).squaredNorm();
        if (distance < nearest) {
          second = nearest;
          second_feature = first_feature;
          nearest = distance;
          first_feature = row + i;
        } else if (distance < second) {
          second = distance;
          second_feature = row + i;
        }
      }
    }
  }
  const float own = displacement_of(*first_feature, p);
  const float t = (std::sqrt(second) - std::sqrt(nearest)) / (kBevel * size_);
  if (t >= 1.0f) return own;
  const float other = displacement_of(*second_feature, p);
  return mix(0.5f * (own + other), own, t * t * (3.0f - 2.0f * t));
}

}  // namespace adit::sim
