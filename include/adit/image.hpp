// Frames and planes as adit sees them: borrowed pixels, never copied, never owned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "adit/api.hpp"

namespace ADIT_API adit {

/// Smallest and largest side of a frame that the finder accepts, in pixels.
inline constexpr int kSideMin_px = 16;
inline constexpr int kSideMax_px = 8192;

/// How the bytes of one pixel are laid out. Channels are 8 bits unless the name says 16.
enum class PixelFormat : std::uint8_t {
  kGrey8,   ///< 1 byte
  kBgr8,    ///< 3 bytes, OpenCV's order
  kRgb8,    ///< 3 bytes
  kBgra8,   ///< 4 bytes, the fourth is ignored
  kRgba8,   ///< 4 bytes, the fourth is ignored
  kGrey16,  ///< 2 bytes in the machine's byte order; FinderConfig::grey16_depth_bits says how many are used
};

/// Bytes from one pixel to the next in the same row (1 to 4), or 0 for a value that is no PixelFormat.
[[nodiscard]] constexpr int bytes_per_pixel(PixelFormat format) noexcept {
  switch (format) {
    case PixelFormat::kGrey8:
      return 1;
    case PixelFormat::kGrey16:
      return 2;
    case PixelFormat::kBgr8:
    case PixelFormat::kRgb8:
      return 3;
    case PixelFormat::kBgra8:
    case PixelFormat::kRgba8:
      return 4;
  }
  return 0;
}

/// A stride that need not be said: that of pixels and channels without a gap. No two bytes are so far apart.
inline constexpr std::ptrdiff_t kSideBySide = std::numeric_limits<std::ptrdiff_t>::min();

/// A frame that belongs to somebody else: a camera driver's buffer, a cv::Mat, a region of a larger image, an array.
/// Row v starts at data + v * stride_bytes; the stride may be negative (bottom-up images) and may hold padding.
/// Pixels lie side by side in a row, and channels in a pixel, unless the last two say otherwise: mirrored pictures,
/// every second column, planes one after the other, columns for rows. Such frames are read where they lie, and judged
/// as their packed copy would be, to the bit; they take longer, for no vector loop fits them.
struct ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;                    ///< px
  int height = 0;                   ///< px
  std::ptrdiff_t stride_bytes = 0;  ///< from one row to the next; |stride| >= width * bytes_per_pixel when packed
  PixelFormat format = PixelFormat::kBgr8;
  std::ptrdiff_t pixel_stride_bytes = kSideBySide;    ///< from one pixel to the next in a row, of either sign
  std::ptrdiff_t channel_stride_bytes = kSideBySide;  ///< from one channel of a pixel to the next, of either sign

  /// The first byte of a row's first pixel.
  [[nodiscard]] const std::uint8_t* row(int v) const noexcept { return data + v * stride_bytes; }
  [[nodiscard]] std::ptrdiff_t pixel_step() const noexcept {
    return pixel_stride_bytes != kSideBySide ? pixel_stride_bytes : bytes_per_pixel(format);
  }
  [[nodiscard]] std::ptrdiff_t channel_step() const noexcept {
    return channel_stride_bytes != kSideBySide ? channel_stride_bytes : 1;
  }
  /// Are the pixels of a row one run of bytes, as loops over rows want them?
  [[nodiscard]] bool is_packed() const noexcept;
};

/// One 8-bit plane that may be written: dark channel, closing, labels, mask.
struct PlaneView {
  std::uint8_t* data = nullptr;
  int width = 0;                    ///< px
  int height = 0;                   ///< px
  std::ptrdiff_t stride_bytes = 0;  ///< >= width

  [[nodiscard]] std::uint8_t* row(int v) const noexcept { return data + v * stride_bytes; }
};

/// One 8-bit plane that may only be read.
struct ConstPlaneView {
  const std::uint8_t* data = nullptr;
  int width = 0;                    ///< px
  int height = 0;                   ///< px
  std::ptrdiff_t stride_bytes = 0;  ///< >= width

  constexpr ConstPlaneView() = default;
  constexpr ConstPlaneView(const std::uint8_t* pixels, int width_px, int height_px, std::ptrdiff_t stride) noexcept
      : data(pixels), width(width_px), height(height_px), stride_bytes(stride) {}
  constexpr ConstPlaneView(const PlaneView& plane) noexcept  // NOLINT: a writable plane may always be read
      : data(plane.data), width(plane.width), height(plane.height), stride_bytes(plane.stride_bytes) {}

  [[nodiscard]] const std::uint8_t* row(int v) const noexcept { return data + v * stride_bytes; }
};

/// Why a view cannot be judged, in words for a person ("the width is 12 px; 16 to 8192 px are possible"
/// without the figures), or an empty view when it can: null data, a side outside
/// [kSideMin_px, kSideMax_px], an unknown format; of packed rows also a stride shorter than a row, and 16-bit data at
/// an odd address (with a pixel_stride_bytes of its own it may lie anywhere).
[[nodiscard]] std::string_view fault_of(const ImageView& view) noexcept;

}  // namespace adit
