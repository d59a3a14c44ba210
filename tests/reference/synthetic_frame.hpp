// Made-up frames and planes for tests and benchmarks: the same seed gives the same picture.
#pragma once

#include <cstdint>
#include <vector>

#include "adit/image.hpp"
#include "reference/morphology_reference.hpp"

namespace adit::reference {

/// What a picture shows.
enum class Content {
  kNoise,      ///< every value equally often
  kGradient,   ///< slow slopes, turning back at the ends
  kFlat,       ///< one value
  kPiecewise,  ///< blocks of one value each
  kImpulses,   ///< single bright and dark pixels on a slope: they print the element's own shape
  kTunnel,     ///< a gallery lit by the camera's own lamp, darkest far ahead
};
inline constexpr Content kContents[] = {Content::kNoise,     Content::kGradient, Content::kFlat,
                                        Content::kPiecewise, Content::kImpulses, Content::kTunnel};
[[nodiscard]] const char* to_string(Content content);

/// A number that depends on all of its inputs and on nothing else.
[[nodiscard]] std::uint64_t hash_of(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0);

[[nodiscard]] Plane synthetic_plane(Content content, int width, int height, std::uint64_t seed);

/// How the rows of a frame lie in memory.
struct Layout {
  int padding_bytes = 0;   ///< after each row but the last
  bool bottom_up = false;  ///< negative stride
};

/// A frame of its own, allocated to the byte. Padding holds noise, and so does alpha.
class Frame {
 public:
  Frame(Content content, PixelFormat format, int width, int height, std::uint64_t seed, Layout layout = {});

  [[nodiscard]] ImageView view() const;
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  PixelFormat format_;
  int width_;
  int height_;
  std::ptrdiff_t row_step_bytes_;
  bool bottom_up_;
  std::vector<std::uint8_t> bytes_;
};

inline constexpr PixelFormat kFormats[] = {PixelFormat::kGrey8, PixelFormat::kBgr8,  PixelFormat::kRgb8,
                                           PixelFormat::kBgra8, PixelFormat::kRgba8, PixelFormat::kGrey16};
[[nodiscard]] const char* to_string(PixelFormat format);

}  // namespace adit::reference
