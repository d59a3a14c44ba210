// The binary image, its moments and its centroid (paper, section 2.2, eq. 8 and 9).
#pragma once

#include <cstdint>
#include <vector>

#include "adit/api.hpp"
#include "adit/camera.hpp"
#include "adit/image.hpp"
#include "adit/kmeans.hpp"

namespace ADIT_API adit {

/// Pixels per grey level of a plane.
[[nodiscard]] Histogram histogram_of(ConstPlaneView plane) noexcept;

/// Eq. (8): moments of the pixels whose level is at most `last_level`. Exact integers: an 8192 x 8192 mask fits.
struct Moments {
  std::uint64_t m00 = 0;  ///< pixels
  std::uint64_t m10 = 0;  ///< sum of u
  std::uint64_t m01 = 0;  ///< sum of v
  std::uint64_t m20 = 0;  ///< sum of u * u
  std::uint64_t m02 = 0;  ///< sum of v * v
};

/// @param columns  scratch of at least plane.width counters.
[[nodiscard]] Moments moments_of(ConstPlaneView plane, int last_level, std::vector<std::uint32_t>& columns) noexcept;

/// Eq. (9): the centroid. m00 must not be 0.
[[nodiscard]] Pixel centroid_of(const Moments& moments) noexcept;

/// How much of the upright box that its spread suggests the region fills: m00 / (12 * sigma_u * sigma_v), at most 1.
/// A filled rectangle gives 1, a filled ellipse 1, two blobs at opposite sides of the frame nearly 0.
[[nodiscard]] double fill_of(const Moments& moments) noexcept;

}  // namespace adit
