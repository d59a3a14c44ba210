// Slow, plain versions of the pixel stages, written from the definitions in the public headers: they judge the fast
// ones. Nothing here is clever, and nothing here calls the fast ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adit/image.hpp"
#include "adit/kmeans.hpp"
#include "adit/morphology.hpp"
#include "adit/region.hpp"

namespace adit::reference {

/// An 8-bit plane of its own, rows one after the other, allocated to the byte.
struct Plane {
  int width = 0;   ///< px
  int height = 0;  ///< px
  std::vector<std::uint8_t> pixels;

  Plane() = default;
  Plane(int width_px, int height_px, std::uint8_t level = 0);
  /// A copy of a plane that lies elsewhere.
  explicit Plane(ConstPlaneView plane);

  [[nodiscard]] std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
  [[nodiscard]] std::uint8_t at(int u, int v) const { return pixels[index(u, v)]; }
  [[nodiscard]] std::uint8_t& at(int u, int v) { return pixels[index(u, v)]; }
  [[nodiscard]] ConstPlaneView view() const { return {pixels.data(), width, height, width}; }
  [[nodiscard]] PlaneView view() { return {pixels.data(), width, height, width}; }
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// Eq. (4) and (5), pixel by pixel: every pixel of the plane that the element covers takes part.
[[nodiscard]] Plane erode(const Plane& in, const StructuringElement& element);
[[nodiscard]] Plane dilate(const Plane& in, const StructuringElement& element);
[[nodiscard]] Plane close(const Plane& in, const StructuringElement& element);

/// The colour channels of a pixel, in grey levels: one of grey, three of colour.
[[nodiscard]] std::vector<int> channels_of(const ImageView& view, int u, int v, int grey16_depth_bits);

/// Eq. (3) over a square patch.
[[nodiscard]] Plane dark_channel(const ImageView& view, int patch_size_px, int grey16_depth_bits);

/// See scattering_depth.hpp: the pixels are put in order, the brightest first.
[[nodiscard]] double atmospheric_light(const ImageView& view, int grey16_depth_bits, const Plane& dark,
                                       double fraction);

[[nodiscard]] Histogram histogram_of(const Plane& plane);

/// Eq. (8).
[[nodiscard]] Moments moments_of(const Plane& plane, int last_level);

/// See region.hpp: spreads about the centroid, summed pixel by pixel.
[[nodiscard]] double fill_of(const Plane& plane, int last_level);

}  // namespace adit::reference
