#include "adit/image.hpp"

namespace adit {

namespace {

bool is_at_odd_address(const ImageView& view) noexcept {
  return reinterpret_cast<std::uintptr_t>(view.data) % 2 != 0 || view.stride_bytes % 2 != 0;
}

}  // namespace

bool ImageView::is_packed() const noexcept {
  const int bytes = bytes_per_pixel(format);
  if (pixel_step() != bytes || (bytes >= 3 && channel_step() != 1)) return false;
  return format != PixelFormat::kGrey16 || pixel_stride_bytes == kSideBySide || !is_at_odd_address(*this);
}

std::string_view fault_of(const ImageView& view) noexcept {
  if (view.data == nullptr) return "there are no pixels (null pointer)";
  const int pixel_bytes = bytes_per_pixel(view.format);
  if (pixel_bytes == 0) return "the pixel format is unknown";
  if (view.width < kSideMin_px || view.width > kSideMax_px) return "the width is not in 16 to 8192 px";
  if (view.height < kSideMin_px || view.height > kSideMax_px) return "the height is not in 16 to 8192 px";
  // Who says where each pixel lies may let rows lie over each other, too: one row for all, columns for rows.
  if (!view.is_packed() || view.pixel_stride_bytes != kSideBySide) return {};
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(view.width) * pixel_bytes;
  // Compared on both sides of zero: the magnitude of the smallest ptrdiff_t does not exist.
  if (view.stride_bytes < row_bytes && view.stride_bytes > -row_bytes) return "the stride is shorter than a row";
  if (view.format == PixelFormat::kGrey16 && is_at_odd_address(view)) {
    return "16-bit pixels are at an odd address or the stride is odd";
  }
  return {};
}

}  // namespace adit
